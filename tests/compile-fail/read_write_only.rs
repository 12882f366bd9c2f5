//! A read of an object that the drive only takes.
//~ E0277: object is write-only: the drive refuses a read with abort 0601 0001
use drivewright_runtime::prelude::*;

const SOFTWARE_RESET: Object<u16, Wo, Unmapped, Raw> = Object::new(0x2FFF, 0);

fn main() {
    let _ = SOFTWARE_RESET.decode(&[0; 2]);
}
