//! Laws of the room `route`.
