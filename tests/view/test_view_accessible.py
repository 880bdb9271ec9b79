"""The page for those who do not see it, who see little, or who have no mouse."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import pytest
from view_chromium import press, state

if TYPE_CHECKING:
    from playwright.sync_api import Page

Visit = Callable[..., "Page"]
WIDE = {"width": 1280, "height": 900}
PANELS = ("Bodies", "Show", "Plots", "About")
TO_BE_NAMED = {
    "button",
    "link",
    "textbox",
    "searchbox",
    "combobox",
    "slider",
    "checkbox",
    "switch",
    "radio",
    "img",
}

# WCAG 2.2, 1.4.3: relative luminance of sRGB, and (lighter + 0.05) / (darker + 0.05) between a text and what
# lies behind it. Layers are laid over each other from the page upwards; as what shines through may have any
# colour, the worse of white and black counts.
CONTRASTS = """() => {
    const parse = text => {
        const parts = text.match(/[\\d.]+/g).map(Number);
        const scale = text.startsWith("color(") ? 255 : 1;
        return [...parts.slice(0, 3).map(part => part * scale), parts[3] ?? 1];
    };
    const over = (upper, lower) => lower.map((below, k) => upper[k] * upper[3] + below * (1 - upper[3]));
    const linear = c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
    const luminance = rgb => rgb.map(c => linear(c / 255))
        .reduce((sum, c, k) => sum + [0.2126, 0.7152, 0.0722][k] * c, 0);
    const ratio = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    const layers = element => {
        const own = parse(getComputedStyle(element).backgroundColor);
        return element.parentElement ? [...layers(element.parentElement), own] : [own];
    };
    const seen = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
        const element = walker.currentNode.parentElement, text = walker.currentNode.data.trim();
        if (!text || !element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
        if (element.closest("script, style, noscript, :disabled, .disabled, [aria-disabled=true]")) continue;
        const style = getComputedStyle(element);
        const ratios = [[0, 0, 0], [255, 255, 255]].map(base => {
            const behind = layers(element).reduce((below, layer) => over(layer, below), base);
            return ratio(luminance(over(parse(style.color), behind)), luminance(behind));
        });
        const size = parseFloat(style.fontSize);
        const large = size >= 24 || (size >= 18.66 && style.fontWeight >= 700);
        seen.push([text.slice(0, 40), Math.min(...ratios), large ? 3 : 4.5]);
    }
    return seen;
}"""


def accessible(page: Page) -> list[tuple[str, str]]:
    """Role and name of everything, as the browser tells screen readers."""
    session = page.context.new_cdp_session(page)
    nodes = session.send("Accessibility.getFullAXTree")["nodes"]
    return [
        (node["role"]["value"], node.get("name", {}).get("value", "").strip())
        for node in nodes
        if not node["ignored"]
    ]


@pytest.mark.parametrize("panel", PANELS)
def test_everything_that_can_be_used_has_a_name(visit: Visit, panel: str) -> None:
    page = visit("machine", viewport=WIDE)
    open_panel(page, panel)
    found = [(role, name) for role, name in accessible(page) if role in TO_BE_NAMED]
    assert len(found) > 10
    assert [role for role, name in found if not name] == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("panel", PANELS)
def test_texts_stand_out(visit: Visit, scheme: str, panel: str) -> None:
    """4.5 : 1, large letters 3 : 1. What cannot be used at the moment may be paler."""
    page = visit("machine", viewport=WIDE, color_scheme=scheme)
    page.evaluate("physsim.select('sledge')")
    open_panel(page, panel)
    seen = page.evaluate(CONTRASTS)
    assert len(seen) > 20
    assert [(text, round(ratio, 2)) for text, ratio, needed in seen if ratio < needed] == []


def open_panel(page: Page, name: str) -> None:
    button = page.get_by_role("toolbar", name="Panels").get_by_role("button", name=name, exact=True)
    if button.get_attribute("aria-expanded") != "true":
        button.click()


def test_nothing_that_changes_all_the_time_is_read_aloud(visit: Visit) -> None:
    """Live regions speak whenever they change: numbers that do so in every picture must not be among them."""
    page = visit("balls", viewport=WIDE)
    page.evaluate("physsim.select('red_ball')")
    live = ":is(output, [role=status], [aria-live=polite], [aria-live=assertive]):not([aria-live=off])"
    before = page.locator(live).all_inner_texts()
    page.evaluate("physsim.seek(0.2)")
    page.get_by_text("at frame 21", exact=True).wait_for()
    assert page.locator(live).all_inner_texts() == before


def test_all_by_keyboard(visit: Visit) -> None:
    """Tab reaches every control and never a dead end; a body is found, selected, followed and left again."""
    page = visit("balls", viewport=WIDE)
    reached = []
    for _ in range(60):
        page.keyboard.press("Tab")
        reached.append(page.evaluate("document.activeElement.ariaLabel ?? document.activeElement.tagName"))
    for name in ("Show all that moves", "Help", "Time", "Play", "Last frame", "Speed of playing", "Loop"):
        assert name in reached, (name, reached)
    page.get_by_role("slider", name="Time").focus()
    page.keyboard.press("/")
    page.keyboard.type("blue")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    assert state(page)["selected"] == "blue_ball"
    page.keyboard.press("f")
    assert page.get_by_role("button", name="Follow").get_attribute("aria-pressed") == "true"
    page.keyboard.press("Escape")
    assert state(page)["selected"] is None


def test_focus_is_seen(visit: Visit) -> None:
    page = visit("balls", viewport=WIDE)
    for name in ("Play", "Loop"):
        button = page.get_by_role("button", name=name, exact=True)
        for _ in range(60):
            page.keyboard.press("Tab")
            if button.evaluate("it => it === document.activeElement"):
                break
        outline: Any = button.evaluate(
            "it => { const s = getComputedStyle(it); return [s.outlineStyle, parseFloat(s.outlineWidth)] }"
        )
        assert outline[0] != "none"
        assert outline[1] >= 2


def test_the_help_opens_and_closes(visit: Visit) -> None:
    page = visit("balls")
    page.keyboard.press("?")
    dialog = page.get_by_role("dialog", name="Keys")
    assert "Space" in dialog.inner_text()
    page.keyboard.press("Escape")
    dialog.wait_for(state="hidden")
    press(page, "Help")
    dialog.wait_for()


def test_less_motion(visit: Visit) -> None:
    """Who asks for less motion gets no page that plays by itself."""
    page = visit("balls", reduced_motion="reduce", viewport=WIDE)
    page.reload()
    page.evaluate("physsim.ready")
    assert not state(page)["playing"]
