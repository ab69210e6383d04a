//! Catalogues of users: what is read, what is refused and how, and that no bytes do harm.

use crate::random::Random;
use lightfall_core::optics::stars::{
    Catalogue, CatalogueError, MAX_NAME_CHARS, MAX_STARS, SOLAR_B_V, celestial_direction,
    temperature_from_b_v,
};

fn read(text: &str) -> Result<Catalogue, CatalogueError> {
    Catalogue::from_csv("my.csv", text)
}

#[test]
fn stars_are_read_with_and_without_a_header() {
    let plain = "10,20,3.5,0.5,Alpha\n# a comment\n\n 30 , -40 , 1.25 \n";
    let header =
        "# two stars\nname,hr,V_MAG,dec_deg,ra_deg,b_v\nAlpha,1,3.5,20,10,0.5\n,2,1.25,-40,30,\n";
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
            "# note\n1,2,3,0.5,\"Alpha\n4,5,6\n7,8,9,,\"Beta\"\n",
            "my.csv: line 2: a quotation mark is not closed: \"Alpha\\n4,5,6\\n7,8,9,,Beta\\\"\"; a field ends in the line in which it begins",
        ),
        (
            &named,
            "my.csv: line 1: name = \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\" is refused: it must be a name of at most 60 characters",
        ),
        (
            "ra,dec_deg,v_mag\n1,2,3\n",
            "my.csv: line 1: the header has no column ra_deg; it needs ra_deg or ra_hours, dec_deg and v_mag, and may have b_v and name",
        ),
        (
            "# mine\nra,dec,mag\n1,2,3\n",
            "my.csv: line 2: the header \"ra,dec,mag\" is not known; call the columns ra_deg or ra_hours, dec_deg, v_mag, b_v and name (the headers of the HYG database and of Gaia's archive are read as they are)",
        ),
        (
            "ra_hours,dec_deg,v_mag\n25,2,3\n",
            "my.csv: line 2: ra_hours = \"25\" is refused: it must be a number from 0 to 24",
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

/// Semicolons with decimal commas, as spreadsheets write them where the comma is the decimal sign,
/// and tabs.
#[test]
fn other_separators_and_decimal_commas_give_the_same_stars() {
    let expected = read("83.822,-5.391,4.3,-0.1,Sword\n30,-40,1.25\n").unwrap();
    for text in [
        "83,822;-5,391;4,3;-0,1;Sword\n30;-40;1,25\n",
        "83,822;-5,391;4,3;-0,1\n",
        "ra_deg;dec_deg;v_mag;b_v;name\r\n83,822;-5,391;4,3;-0,1;Sword\r\n30;-40;1,25;;\r\n",
        "83.822\t-5.391\t4.3\t-0.1\tSword\n30\t-40\t1.25\n",
        "\"83,822\",\"-5,391\",\"4,3\",\"-0,1\",Sword\n30,-40,\"1,25\"\n",
        "ra_hours,dec_deg,v_mag,b_v,name\n5.588133333333333,-5.391,4.3,-0.1,Sword\n2,-40,1.25\n",
    ] {
        let catalogue = read(text).unwrap();
        let stars = catalogue.stars();
        assert_eq!(stars.last(), expected.stars().last(), "for {text:?}");
        assert!(stars.len() == 1 || catalogue == expected, "for {text:?}");
    }
}

/// Lines of the HYG database, versions 4.1 and 1, and of AT-HYG.
#[test]
fn the_columns_of_the_hyg_database_are_read_in_hours_and_without_the_sun() {
    let of = |header: &str, sun: &str, sirius: &str| {
        let catalogue = read(&format!("{header}\n{sun}\n{sirius}\n")).unwrap();
        let [star] = catalogue.stars() else {
            panic!("one star in {header}");
        };
        let direction = celestial_direction(101.287_155, -16.716_116).as_vec3();
        assert!(star.direction.distance(direction) < 1e-6);
        assert_eq!(star.magnitude, -1.44);
        assert_eq!(star.temperature, temperature_from_b_v(0.009) as f32);
        assert_eq!(catalogue.names()[0].name, "Sirius");
        assert!(catalogue.remarks()[0].contains("HYG"));
        assert_eq!(catalogue.remarks().len(), 1);
    };
    of(
        "\"id\",\"hip\",\"hd\",\"hr\",\"gl\",\"bf\",\"proper\",\"ra\",\"dec\",\"dist\",\"mag\",\"absmag\",\"spect\",\"ci\"",
        "0,,,,\"\",\"\",\"Sol\",0.000000,0.000000,0.0000,-26.700,4.850,\"G2V\",0.656",
        "32263,32349,48915,2491,\"Gl 244A\",\"9Alp CMa\",\"Sirius\",6.752477,-16.716116,2.6371,-1.440,1.454,\"A0m...\",0.009",
    );
    of(
        "StarID,HIP,HD,HR,Gliese,BayerFlamsteed,ProperName,RA,Dec,Distance,Mag,AbsMag,Spectrum,ColorIndex",
        "0,,,,,,Sol,0,0,0.000004848,-26.73,4.85,G2V,0.656",
        "32263,32349,48915,2491,Gl 244A,9Alp CMa,Sirius,6.752477,-16.716116,2.6371,-1.44,1.454,A0m,0.009",
    );
    of(
        "id,tyc,gaia,hyg,hip,proper,ra,dec,pos_src,dist,mag,absmag,ci,mag_src",
        "1,,,0,,Sol,0.0,0.0,OTHER,0.0,-26.7,4.85,0.656,HYG",
        "2,5949-2777-1,,32263,32349,Sirius,6.752477,-16.716116,T,2.6371,-1.44,1.454,0.009,HIP",
    );
}

/// The columns of Gaia's archive, and of its bulk files, which write `null`.
#[test]
fn the_columns_of_gaia_are_read_with_its_magnitudes_and_colours() {
    let catalogue = read(
        "# %ECSV 1.0\nsolution_id,source_id,ra,dec,parallax,phot_g_mean_mag,bp_rp\n\
         1,10,10.5,-20.25,1.0,8.0,0.82\n1,11,200.0,30.0,null,9.0,null\n1,12,30.0,40.0,2.0,null,null\n",
    )
    .unwrap();
    let [first, second] = catalogue.stars() else {
        panic!("two stars");
    };
    // The Sun: V - G is 0.15, and its temperature 5772 K; the relation holds to 61 K.
    assert!((first.magnitude - 8.152).abs() < 0.001, "{first:?}");
    assert!((first.temperature - 5772.0).abs() < 2.0 * 61.0, "{first:?}");
    assert_eq!(second.temperature, first.temperature);
    assert_eq!(first.direction, celestial_direction(10.5, -20.25).as_vec3());
    assert_eq!(
        catalogue.remarks()[1],
        "1 of 3 lines are left out, because they have no phot_g_mean_mag"
    );
}

#[test]
fn right_ascensions_that_are_probably_hours_are_remarked_on() {
    let hours = "5.5,-5,1\n23.9,80,2\n";
    assert!(read(hours).unwrap().remarks()[0].contains("ra_hours"));
    for text in [
        "5.5,-5,1\n24,80,2\n",
        "5.5,-5,1\n",
        &format!("ra_hours,dec_deg,v_mag\n{hours}"),
    ] {
        assert_eq!(read(text).unwrap().remarks(), [""; 0], "for {text:?}");
    }
    assert_eq!(Catalogue::built_in().remarks(), [""; 0]);
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
        match Catalogue::from_csv("garbled", &String::from_utf8_lossy(&text)) {
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
