//! Runs svd2rust's library on an SVD in memory: `peer-svd2rust IN OUT RUNS` prints the seconds of each run.

use std::time::Instant;

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let [_, input, output, runs] = args.as_slice() else { panic!("peer-svd2rust IN OUT RUNS") };
    let text = std::fs::read_to_string(input).expect("the SVD");
    let mut config = svd2rust::Config::default();
    config.target = svd2rust::Target::None;
    let mut code = String::new();
    for _ in 0..runs.parse().expect("a number") {
        let start = Instant::now();
        code = svd2rust::generate(&text, &config).expect("an SVD").lib_rs;
        println!("{}", start.elapsed().as_secs_f64());
    }
    std::fs::write(output, code).expect("the output");
}
