use cssm_core::LightCase;
#[test]
fn t() {
    let case = LightCase::builder("Sun").doc("Sun over an open world.").build().unwrap();
    match cssm_codegen::generate(&case) {
        Ok(g) => println!("{}\n{}\n{}", g.rust, g.json, g.explain),
        Err(e) => panic!("{e}"),
    }
}
