//! A page: its head, its look, and what may stand in it.

/// The look of all pages: night, with a serif.
const STYLE: &str = include_str!("page.css");

/// The page's colour, around the pictures too.
pub const BACKGROUND: [u8; 3] = [0x0d, 0x11, 0x18];

/// A page with a look of its own beside that of all pages.
pub fn html(title: &str, description: &str, style: &str, body: &str) -> String {
    format!(
        r#"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<meta name="description" content="{description}">
<style>
{STYLE}{style}</style>
</head>
<body>
{body}</body>
</html>
"#
    )
}

/// A text that stands for itself.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
