//! Times of the engine's parts: `cargo bench --bench parts [-- NAME]`.

#[path = "../tests/common/mod.rs"]
mod common;
mod kernels;

fn names() -> impl Iterator<Item = &'static str> {
    kernels::all().into_iter().map(|(name, _)| name)
}

#[divan::bench(args = names())]
fn part(bencher: divan::Bencher, name: &str) {
    let mut kernel = kernels::ready(name).expect("it is one of them");
    bencher.bench_local(&mut kernel);
}

fn main() {
    divan::main();
}
