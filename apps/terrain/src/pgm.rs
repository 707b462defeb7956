//! Grey pictures of 16 bits, as PGM has them.

/// Numbers in rows.
pub struct Grey {
    pub columns: usize,
    pub rows: usize,
    pub values: Vec<u16>,
}

/// Reads a picture.
///
/// # Errors
/// What is wrong with it, in one line.
pub fn parse(bytes: &[u8]) -> Result<Grey, String> {
    let mut rest = bytes.strip_prefix(b"P5").ok_or("no binary PGM")?;
    let [columns, rows, most] = [number(&mut rest)?, number(&mut rest)?, number(&mut rest)?];
    if most <= 255 {
        return Err("a PGM of 8 bits, not 16".to_owned());
    }
    // One blank after the header.
    let samples = rest.get(1..).unwrap_or_default();
    if columns == 0 || rows == 0 || columns.checked_mul(rows) != Some(samples.len() / 2) {
        return Err(format!(
            "{columns} by {rows} samples are not in {} bytes",
            samples.len()
        ));
    }
    Ok(Grey {
        columns,
        rows,
        values: samples
            .as_chunks()
            .0
            .iter()
            .map(|&pair| u16::from_be_bytes(pair))
            .collect(),
    })
}

/// The next number of the header, after blanks and comments.
fn number(rest: &mut &[u8]) -> Result<usize, String> {
    loop {
        *rest = rest.trim_ascii_start();
        if rest.first() != Some(&b'#') {
            break;
        }
        let end = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        *rest = &rest[end..];
    }
    let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let (number, after) = rest.split_at(digits);
    *rest = after;
    std::str::from_utf8(number)
        .ok()
        .and_then(|text| text.parse().ok())
        .ok_or_else(|| "a PGM without its size".to_owned())
}
