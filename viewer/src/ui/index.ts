// Everything a person touches in the page. `mountUi` builds it around the view.

import type { App, Ui } from "../app";
import { AboutPanel, Badge } from "./about";
import { Bar } from "./bar";
import { Bodies } from "./bodies";
import { keepColours } from "./colouring";
import { button, element, icon } from "./dom";
import { BodyFrames, WorldAxes } from "./draw/axes";
import { CenterDrawing } from "./draw/centers";
import { ContactDrawing } from "./draw/contacts";
import { JointDrawing } from "./draw/joints";
import { SelectedLinkDrawing } from "./draw/selected_link";
import { SpringDrawing } from "./draw/springs";
import { TrailDrawing } from "./draw/trails";
import { help } from "./help";
import { ABOUT, BODIES, FIT, HELP, PLOTS, SHOW } from "./icons";
import { listenToKeys } from "./keys";
import { Labels } from "./labels";
import { Legend } from "./legend";
import { paced } from "./pace";
import { Panels } from "./panels";
import { listenToPicks } from "./picking";
import { Plots } from "./plots";
import { Selection } from "./selection";
import { Store } from "./settings";
import { shortcuts } from "./shortcuts";
import { showPanel } from "./show";
import { keepTheme } from "./theme";
import "./viewer.css";

/** Windows of this width have room for the plots beside the view from the start [px]. */
const ROOMY = 1000;

/** What is shown around the view. */
interface Parts {
  readonly bar: Bar;
  readonly badge: Badge;
  readonly about: AboutPanel;
  readonly plots: Plots;
  readonly bodies: Bodies;
  readonly panels: Panels;
}

export function mountUi(app: App): Ui {
  const { recording, world, root } = app;
  const store = new Store();
  const selection = new Selection(recording);
  const legend = new Legend(recording, world, store, draw(app, store, selection));
  const parts = partsOf(app, store, selection);
  const { bar, badge, bodies, panels, plots } = parts;
  const keys = shortcuts({
    app, store, selection, panels, openHelp: () => openHelp(),
    findPlot: () => (panels.show("Plots"), plots.focus()),
    findBody: () => (panels.show("Bodies"), selection.select(null), bodies.focus()),
  });
  const openHelp = help(root, keys);
  root.append(header(app, panels, badge, openHelp), panels.sides.left, panels.sides.right, legend.element, bar.element);
  listenToKeys(keys);
  listenToPicks(world, (body) => selection.selectBody(body));
  keepSelection(app, selection, panels);
  keepWorld(app, store, plots);
  keepTime(app, parts);
  if (window.innerWidth >= ROOMY && !plots.isEmpty) panels.show("Plots");
  return { selected: () => selection.body, select: (body) => selection.selectBody(body) };
}

function partsOf(app: App, store: Store, selection: Selection): Parts {
  const { recording, player, world } = app;
  const about = new AboutPanel(recording, world);
  const plots = new Plots(recording, player);
  const bodies: Bodies = new Bodies(recording, player, selection, (name) => {
    panels.show("Plots");
    plots.addNamed(name);
  });
  const panels: Panels = new Panels([
    { name: "Bodies", key: "", side: "left", icon: BODIES, content: bodies.element },
    { name: "Show", key: "", side: "left", icon: SHOW, content: showPanel(app, store) },
    { name: "Plots", key: "P", side: "right", icon: PLOTS, content: plots.element },
    { name: "About", key: "I", side: "left", icon: ABOUT, content: about.element },
  ], () => layOut(app, panels, plots));
  return { bar: new Bar(player), badge: new Badge(recording), about, plots, bodies, panels };
}

/** Everything that is drawn into the view; the force arrows are handed out, for the legend. */
function draw({ recording, world, root }: App, store: Store, selection: Selection): ContactDrawing {
  new JointDrawing(recording, world, store);
  new SpringDrawing(recording, world, store);
  new TrailDrawing(recording, world, store, selection);
  new WorldAxes(world, store);
  new BodyFrames(recording, world, store);
  new CenterDrawing(recording, world, store);
  new SelectedLinkDrawing(recording, world, selection);
  new Labels(root, recording, world, store);
  return new ContactDrawing(recording, world, store, selection);
}

function header({ recording, world }: App, panels: Panels, badge: Badge, openHelp: () => void): HTMLElement {
  const { title, file } = recording.about;
  panels.buttons.append(
    button("Show all that moves", icon(...FIT), "R", () => world.frameAll()), button("Help", icon(...HELP), "?", openHelp),
  );
  const name = element("h1", { title: title || file }, title || file);
  return element("header", { class: "top" }, element("div", { class: "title" }, name, badge.element), panels.buttons);
}

/** Room for the view between the panels. */
function layOut({ root, player }: App, panels: Panels, plots: Plots): void {
  root.classList.toggle("has-left", !panels.sides.left.hidden);
  root.classList.toggle("has-right", !panels.sides.right.hidden);
  if (player.recording.frames) plots.update();
}

function keepSelection({ world }: App, selection: Selection, panels: Panels): void {
  let shown = selection.subject;
  selection.onChange(() => {
    world.setSelected(selection.body);
    world.follow(selection.followed);
    world.redraw();
    if (selection.subject && selection.subject !== shown) panels.show("Bodies");
    shown = selection.subject;
  });
}

function keepWorld({ recording, world }: App, store: Store, plots: Plots): void {
  keepColours(recording, world, store);
  keepTheme(world, store, () => plots.redraw());
  store.watch(["grid"], () => world.setGrid(store.now.grid));
  store.watch(["wireframe"], () => world.setCollisionShapes(store.now.wireframe));
  store.watch(["shadows"], () => world.setShadows(store.now.shadows));
}

/** What goes with the time, and with the growth of a run that is watched. */
function keepTime({ player, recording }: App, { bar, badge, about, bodies, plots }: Parts): void {
  player.onChange(() => {
    bar.update();
    bodies.update();
    plots.update();
  });
  recording.onGrowth(paced(() => {
    about.update();
    badge.update();
    bar.update();
  }, 500));
}
