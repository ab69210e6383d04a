//! Catalogues of users: what is read, what is refused and how, and that no bytes do harm.

use crate::random::Random;
use lightfall_core::optics::stars::{
    Catalogue, CatalogueError, MAX_NAME_CHARS, MAX_STARS, SOLAR_B_V, celestial_direction,
    temperature_from_b_v,
};

fn read(text: &str) -> Result<Catalogue, CatalogueError> {
    Catalogue::from_csv("my.csv", text.as_bytes())
}

#[test]
fn stars_are_read_with_and_without_a_header() {
    let plain = "10,20,3.5,0.5,Alpha\n# a comment\n\n 30 , -40 , 1.25 \n";
    let header = "\u{feff}# two stars\nname,hr,V_MAG,dec_deg,ra_deg,b_v\nAlpha,1,3.5,20,10,0.5\n,2,1.25,-40,30,\n";
    for text in [plain, header] {
        let catalogue = read(text).unwrap();
        let [first, second] = catalogue.stars() else {
            panic!("two stars in {text}");
        };
        assert_eq!((first.magnitude, second.magnitude), (1.25, 3.5));
        assert_eq!(first.temperature, temperature_from_b_v(SOLAR_B_V) as f32);
        assert_eq!(second.temperature, temperature_from_b_v(0.5) as f32);
        assert_eq!(second.direction, celestial_direction(10.0, 20.0).as_vec3());
        assert_eq!(catalogue.names().len(), 1);
        assert_eq!(catalogue.names()[0].name, "Alpha");
        assert_eq!(catalogue.names()[0].star, *second);
    }
}

#[test]
fn a_refusal_names_the_line_the_column_what_was_given_and_what_is_allowed() {
    let long = "x".repeat(MAX_NAME_CHARS + 1);
    let named = format!("1,2,3,,{long}\n");
    for (text, sentence) in [
        (
            "# note\n1,2,3\n \n\n# note\n400,2,3\n",
            "my.csv: line 6: ra_deg = \"400\" is refused: it must be a number from 0 to 360",
        ),
        (
            "1,-90.5,3",
            "my.csv: line 1: dec_deg = \"-90.5\" is refused: it must be a number from -90 to 90",
        ),
        (
            "1,2,bright",
            "my.csv: line 1: v_mag = \"bright\" is refused: it must be a number from -30 to 30",
        ),
        (
            "1,2",
            "my.csv: line 1: v_mag = \"\" is refused: it must be a number from -30 to 30",
        ),
        (
            "83.8 -5.4 1.0\n",
            "my.csv: line 1: ra_deg = \"83.8 -5.4 1.0\" is refused: it must be a number from 0 to 360",
        ),
        (
            "5h35m,-5,1\n",
            "my.csv: line 1: ra_deg = \"5h35m\" is refused: it must be a number from 0 to 360",
        ),
        (
            "1,2,3,NaN",
            "my.csv: line 1: b_v = \"NaN\" is refused: it must be a number, or empty if it is not known",
        ),
        (
            &named,
            "my.csv: line 1: name = \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\" is refused: it must be a name of at most 60 characters",
        ),
        (
            "ra,dec_deg,v_mag\n1,2,3\n",
            "my.csv: line 1: the header has no column ra_deg; it needs ra_deg, dec_deg and v_mag and may have b_v and name",
        ),
        (
            "# mine\nra_deg;dec_deg;v_mag\n1;2;3\n",
            "my.csv: line 2: its fields are separated by semicolons, and must be separated by commas",
        ),
        (
            "1\t2\t3\n",
            "my.csv: line 1: its fields are separated by tabs, and must be separated by commas",
        ),
        (
            "# nothing\n",
            "my.csv has no star; a star is a line ra_deg,dec_deg,v_mag,b_v,name, the last two of which may be left out",
        ),
    ] {
        assert_eq!(
            read(text).unwrap_err().to_string(),
            sentence,
            "for {text:?}"
        );
    }
}

#[test]
fn a_catalogue_has_at_most_two_million_stars() {
    let text = "1,2,3\n".repeat(MAX_STARS);
    assert_eq!(read(&text).unwrap().stars().len(), MAX_STARS);
    let error = read(&(text + "1,2,3\n")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "my.csv: line 2000001 is one star too many: a catalogue has at most 2000000 stars"
    );
}

#[test]
fn random_bytes_are_read_or_refused() {
    let mut random = Random::new();
    let start =
        b"ra_deg,dec_deg,v_mag,b_v,name\n10,20,3.5,0.5,Alpha\n30,-40,1.25,,\"A \"\"B\"\"\"\n";
    let (mut refused, mut accepted) = (0, 0);
    for _ in 0..5000 {
        let mut text = start.to_vec();
        for _ in 0..random.integer(1, 4) {
            let place = random.integer(0, text.len() as u32 - 1) as usize;
            match random.integer(0, 3) {
                0 => text[place] = random.integer(0, 255) as u8,
                1 => text.insert(place, random.of(b"\",#\n\r\0-.e9\xff")),
                2 => drop(text.remove(place)),
                _ => text.truncate(place),
            }
            text.push(b'\n');
        }
        match Catalogue::from_csv("garbled", &text) {
            Ok(catalogue) => {
                accepted += 1;
                for star in catalogue.stars() {
                    assert!(star.direction.is_normalized() && star.flux().is_finite());
                    assert!(star.flux() > 0.0 && star.angular_radius() > 0.0);
                }
            }
            Err(error) => {
                refused += 1;
                assert!(error.to_string().starts_with("garbled"), "{error}");
            }
        }
    }
    assert!(
        refused > 500 && accepted > 500,
        "{refused} refused, {accepted} accepted"
    );
}
