//! Runs zencan-build's library on a device config in memory: `peer-zencan IN OUT RUNS` prints the seconds of each run.

use std::time::Instant;

use zencan_common::device_config::DeviceConfig;

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let [_, input, output, runs] = args.as_slice() else { panic!("peer-zencan IN OUT RUNS") };
    let text = std::fs::read_to_string(input).expect("the device config");
    let mut code = String::new();
    for _ in 0..runs.parse().expect("a number") {
        let start = Instant::now();
        let config = DeviceConfig::load_from_str(&text).expect("a device config");
        code = zencan_build::device_config_to_string(&config, true).expect("code");
        println!("{}", start.elapsed().as_secs_f64());
    }
    std::fs::write(output, code).expect("the output");
}
