//! Vectors of three components. They are written out: the optimiser does not see through iterators where overflow is checked, and
//! tests spend much of their time here.

pub type Vector = [f64; 3];

pub fn dot([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> f64 {
    ax * bx + ay * by + az * bz
}

pub fn cross([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

pub fn plus([ax, ay, az]: Vector, s: f64, [bx, by, bz]: Vector) -> Vector {
    [ax + s * bx, ay + s * by, az + s * bz]
}

pub fn minus([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ax - bx, ay - by, az - bz]
}

pub fn length(v: Vector) -> f64 {
    dot(v, v).sqrt()
}

pub fn unit([x, y, z]: Vector) -> Vector {
    let length = length([x, y, z]);
    [x / length, y / length, z / length]
}

/// The point of a bilinear patch between four corners, in the order of `Corner::ALL`, at places s and t in [0, 1].
pub fn blend([a, b, c, d]: [Vector; 4], s: f64, t: f64) -> Vector {
    let between = |s: f64, [ax, ay, az]: Vector, [bx, by, bz]: Vector| {
        [
            ax * s + bx * (1.0 - s),
            ay * s + by * (1.0 - s),
            az * s + bz * (1.0 - s),
        ]
    };
    between(t, between(s, a, b), between(s, d, c))
}
