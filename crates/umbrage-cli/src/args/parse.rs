//! What is typed on the command line, as numbers and names.

use glam::Vec3;
use umbrage_rivals::Family;

/// Three finite numbers, as `1.5,2,-3`.
pub fn vec3(text: &str) -> Result<Vec3, String> {
    let numbers: Vec<f32> =
        text.split(',').filter_map(|n| n.trim().parse().ok()).filter(|n: &f32| n.is_finite()).collect();
    match numbers[..] {
        [x, y, z] if text.split(',').count() == 3 => Ok(Vec3::new(x, y, z)),
        _ => Err("wanted three numbers, as 1.5,2,-3".to_owned()),
    }
}

/// Metres, 0 or more.
pub fn distance(text: &str) -> Result<f32, String> {
    let metres = text.parse().ok().filter(|metres: &f32| metres.is_finite() && *metres >= 0.0);
    metres.ok_or_else(|| "wanted metres, 0 or more".to_owned())
}

/// Reads the length of a day, from 1 to 1e9 seconds.
pub fn day(text: &str) -> Result<f32, String> {
    let seconds = text.parse().ok().filter(|seconds| (1.0..=1e9).contains(seconds));
    seconds.ok_or_else(|| "wanted seconds, from 1 to 1e9".to_owned())
}

/// Degrees from 0 to 90.
pub fn sun_angle(text: &str) -> Result<f64, String> {
    let angle = text.parse().ok().filter(|angle| (0.0..=90.0).contains(angle));
    angle.ok_or_else(|| "wanted degrees, from 0 to 90".to_owned())
}

/// A family of shadows, by its kind or as a TOML table.
pub fn family(text: &str) -> Result<Family, String> {
    #[derive(serde::Deserialize)]
    struct Given {
        family: Family,
    }
    let table =
        if text.trim_start().starts_with('{') { text.to_owned() } else { format!("{{ kind = {text:?} }}") };
    let given: Result<Given, _> = toml::from_str(&format!("family = {table}"));
    let family = given.map(|given| given.family).map_err(|wrong| wrong.message().to_owned())?;
    family.validate().map(|()| family).map_err(|wrong| wrong.to_string())
}

/// Degrees from 0 to below 180.
pub fn area_degrees(text: &str) -> Result<f32, String> {
    let degrees = text.parse().ok().filter(|degrees| (0.0..180.0).contains(degrees));
    degrees.ok_or_else(|| "wanted degrees, from 0 to below 180".to_owned())
}

/// Stops of exposure, from -100 to 100.
pub fn stops(text: &str) -> Result<f32, String> {
    let stops = text.parse().ok().filter(|stops| (-100.0..=100.0).contains(stops));
    stops.ok_or_else(|| "wanted stops, from -100 to 100".to_owned())
}

/// An illuminance, lux.
pub fn lux(text: &str) -> Result<f32, String> {
    let lux = text.parse().ok().filter(|lux| (1e-6..=1e9).contains(lux));
    lux.ok_or_else(|| "wanted lux, from 1e-6 to 1e9".to_owned())
}

/// Pixels, as `1280x720`.
pub fn size(text: &str) -> Result<(u32, u32), String> {
    let wanted = || "wanted width x height in pixels, as 1280x720".to_owned();
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(wanted)?;
    let (width, height) = (width.parse().map_err(|_| wanted())?, height.parse().map_err(|_| wanted())?);
    if width == 0 || height == 0 {
        return Err(format!("a picture needs at least one pixel each way, got {width} x {height}"));
    }
    Ok((width, height))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exposures_are_read_or_refused() {
        assert_eq!((stops("-100"), stops("0.5"), lux("1e5")), (Ok(-100.0), Ok(0.5), Ok(100_000.0)));
        for wrong in ["", "101", "-100.5", "nan", "inf", "bright"] {
            assert!(stops(wrong).is_err(), "{wrong}");
        }
        for wrong in ["", "0", "-3", "nan", "inf", "1e10"] {
            assert!(lux(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn vectors_and_sizes_are_read_or_refused() {
        assert_eq!(vec3("1, -2.5,3e1"), Ok(Vec3::new(1.0, -2.5, 30.0)));
        for wrong in ["", "1,2", "1,2,3,4", "a,b,c", "1,nan,2", "1,,2,3"] {
            assert!(vec3(wrong).is_err(), "{wrong}");
        }
        assert_eq!(distance("0.25"), Ok(0.25));
        for wrong in ["", "-1", "nan", "inf", "1e99", "near"] {
            assert!(distance(wrong).is_err(), "{wrong}");
        }
        assert_eq!((day("1"), day("86400")), (Ok(1.0), Ok(86_400.0)));
        for wrong in ["", "0", "0.5", "-600", "nan", "inf", "noon"] {
            assert!(day(wrong).is_err(), "{wrong}");
        }
        assert_eq!(size("640x360"), Ok((640, 360)));
        for wrong in ["", "640", "0x5", "5x0", "-1x5", "axb"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
    }
}
