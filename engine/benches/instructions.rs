//! One kernel once, between two that are not counted: for a tool that counts instructions inside `measured`.
//!
//! Without an argument the names of all kernels are printed. `python -m benchmarks.instructions` uses both.

#[path = "../tests/common/mod.rs"]
mod common;
mod kernels;

#[inline(never)]
fn measured(kernel: &mut dyn FnMut()) {
    kernel();
}

fn main() {
    // cargo adds `--bench`.
    let Some(name) = std::env::args().skip(1).find(|given| given != "--bench") else {
        kernels::all()
            .iter()
            .for_each(|(name, _)| println!("{name}"));
        return;
    };
    let mut kernel = kernels::ready(&name).unwrap_or_else(|| panic!("no kernel '{name}'"));
    kernel();
    measured(&mut kernel);
}
