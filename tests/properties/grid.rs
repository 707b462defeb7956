//! Laws of the room `grid`.
