//! The ellipsoids that have a name: one line each.

use core::str::FromStr;

use super::Ellipsoid;
use crate::Real;
use crate::name::unknown;
use crate::real::literal;

macro_rules! named {
    ($($(#[$doc:meta])* $constant:ident $name:literal $a:expr, $f:expr;)*) => {
        /// The names that [`Ellipsoid::named`] knows: Earth's ellipsoids first, then the other bodies from
        /// the Sun outward.
        pub const NAMED: &[&str] = &[$($name),*];

        /// The named ellipsoids, as constants of every scalar.
        ///
        /// In an expression, Rust does not assume `f64`: where nothing else tells the scalar, write it, as in
        /// `let earth: Ellipsoid = Ellipsoid::WGS84`.
        impl<T: Real> Ellipsoid<T> {
            $(
                $(#[$doc])*
                #[doc = concat!("\n\nName: `", $name, "`.")]
                pub const $constant: Self = Self::within(literal!(T, $a), literal!(T, $f));
            )*

            /// Returns the ellipsoid with a name of [`NAMED`].
            ///
            /// [`str::parse`] does the same.
            ///
            /// # Errors
            /// [`UnknownEllipsoid`] if no ellipsoid has this name. Names are in lower case.
            ///
            /// ```
            /// use terrella::Ellipsoid;
            /// assert_eq!(Ellipsoid::named("mars"), Ok(Ellipsoid::<f32>::MARS));
            /// assert_eq!("krassovsky1940".parse(), Ok(Ellipsoid::<f64>::KRASSOVSKY1940));
            /// ```
            pub fn named(name: &str) -> Result<Self, UnknownEllipsoid> {
                match name {
                    $($name => Ok(Self::$constant),)*
                    _ => Err(UnknownEllipsoid::new(name)),
                }
            }
        }
    };
}

named! {
    /// World Geodetic System 1984 (EPSG:7030): a = 6 378 137 m, 1/f = 298.257223563.
    WGS84 "wgs84" 6_378_137.0, 1.0 / 298.257_223_563;
    /// Geodetic Reference System 1980 (EPSG:7019): a = 6 378 137 m, 1/f = 298.257222101.
    GRS80 "grs80" 6_378_137.0, 1.0 / 298.257_222_101;
    /// Clarke 1866 (EPSG:7008): a = 6 378 206.4 m, b = 6 356 583.8 m.
    CLARKE1866 "clarke1866" 6_378_206.4, 21_622.6 / 6_378_206.4;
    /// International 1924 (EPSG:7022): a = 6 378 388 m, 1/f = 297.
    INTERNATIONAL1924 "international1924" 6_378_388.0, 1.0 / 297.0;
    /// Hayford 1909, another name of [`INTERNATIONAL1924`](Self::INTERNATIONAL1924).
    HAYFORD "hayford" 6_378_388.0, 1.0 / 297.0;
    /// Airy 1830 (EPSG:7001): a = 6 377 563.396 m, 1/f = 299.3249646.
    AIRY1830 "airy1830" 6_377_563.396, 1.0 / 299.324_964_6;
    /// Airy modified 1849 (EPSG:7002): a = 6 377 340.189 m, 1/f = 299.3249646.
    AIRY_MODIFIED "airy-modified" 6_377_340.189, 1.0 / 299.324_964_6;
    /// Bessel 1841 (EPSG:7004): a = 6 377 397.155 m, 1/f = 299.1528128.
    BESSEL1841 "bessel1841" 6_377_397.155, 1.0 / 299.152_812_8;
    /// Bessel modified, of Norway (EPSG:7005): a = 6 377 492.018 m, 1/f = 299.1528128.
    BESSEL_MODIFIED "bessel-modified" 6_377_492.018, 1.0 / 299.152_812_8;
    /// Bessel Namibia (EPSG:7046): a = 6 377 397.155 legal German metres of 1.0000135965 m, 1/f =
    /// 299.1528128.
    BESSEL_NAMIBIA "bessel-namibia" 6_377_397.155 * 1.000_013_596_5, 1.0 / 299.152_812_8;
    /// Clarke 1858 (EPSG:7007): a = 20 926 348, b = 20 855 233 Clarke's feet of 0.3047972654 m.
    CLARKE1858 "clarke1858" 20_926_348.0 * 0.304_797_265_4, 71_115.0 / 20_926_348.0;
    /// Clarke 1880 (EPSG:7034): a = 20 926 202, b = 20 854 895 Clarke's feet of 0.3047972654 m.
    CLARKE1880 "clarke1880" 20_926_202.0 * 0.304_797_265_4, 71_307.0 / 20_926_202.0;
    /// Clarke 1880 (Arc) (EPSG:7013): a = 6 378 249.145 m, 1/f = 293.4663077.
    CLARKE1880_ARC "clarke1880-arc" 6_378_249.145, 1.0 / 293.466_307_7;
    /// Clarke 1880 (Benoit) (EPSG:7010): a = 6 378 300.789 m, b = 6 356 566.435 m.
    CLARKE1880_BENOIT "clarke1880-benoit" 6_378_300.789, 21_734.354 / 6_378_300.789;
    /// Clarke 1880 (IGN), of France and its maps (EPSG:7011): a = 6 378 249.2 m, b = 6 356 515 m.
    CLARKE1880_IGN "clarke1880-ign" 6_378_249.2, 21_734.2 / 6_378_249.2;
    /// Clarke 1880 (RGS), the usual one (EPSG:7012): a = 6 378 249.145 m, 1/f = 293.465.
    CLARKE1880_RGS "clarke1880-rgs" 6_378_249.145, 1.0 / 293.465;
    /// Clarke 1880 (SGA 1922) (EPSG:7014): a = 6 378 249.2 m, 1/f = 293.46598.
    CLARKE1880_SGA1922 "clarke1880-sga1922" 6_378_249.2, 1.0 / 293.465_98;
    /// Everest, 1830 definition (EPSG:7042): a = 20 922 931.8, b = 20 853 374.58 Indian feet of 12/39.370142
    /// m.
    EVEREST1830 "everest1830" 20_922_931.8 * (12.0 / 39.370_142), 69_557.22 / 20_922_931.8;
    /// Everest 1830, adjustment of 1937: India, Bangladesh (EPSG:7015): a = 6 377 276.345 m, 1/f = 300.8017.
    EVEREST1830_1937 "everest1830-1937" 6_377_276.345, 1.0 / 300.801_7;
    /// Everest 1830, definition of 1962: Pakistan (EPSG:7044): a = 6 377 301.243 m, 1/f = 300.8017255.
    EVEREST1830_1962 "everest1830-1962" 6_377_301.243, 1.0 / 300.801_725_5;
    /// Everest 1830, definition of 1967: Sabah, Sarawak (EPSG:7016): a = 6 377 298.556 m, 1/f = 300.8017.
    EVEREST1830_1967 "everest1830-1967" 6_377_298.556, 1.0 / 300.801_7;
    /// Everest 1830, definition of 1975: India (EPSG:7045): a = 6 377 299.151 m, 1/f = 300.8017255.
    EVEREST1830_1975 "everest1830-1975" 6_377_299.151, 1.0 / 300.801_725_5;
    /// Everest 1830 (RSO 1969): Malaysia (EPSG:7056): a = 6 377 295.664 m, 1/f = 300.8017.
    EVEREST1830_RSO1969 "everest1830-rso1969" 6_377_295.664, 1.0 / 300.801_7;
    /// Everest 1830 modified: Malaysia, Singapore (EPSG:7018): a = 6 377 304.063 m, 1/f = 300.8017.
    EVEREST1830_MODIFIED "everest1830-modified" 6_377_304.063, 1.0 / 300.801_7;
    /// Zach 1812 (EPSG:1026): a = 6 376 045 m, 1/f = 310.
    ZACH1812 "zach1812" 6_376_045.0, 1.0 / 310.0;
    /// Plessis 1817 (EPSG:7027): a = 6 376 523 m, 1/f = 308.64.
    PLESSIS1817 "plessis1817" 6_376_523.0, 1.0 / 308.64;
    /// Struve 1860 (EPSG:7028): a = 6 378 298.3 m, 1/f = 294.73.
    STRUVE1860 "struve1860" 6_378_298.3, 1.0 / 294.73;
    /// Danish 1876 (EPSG:7051): a = 6 377 019.27 m, 1/f = 300.
    DANISH1876 "danish1876" 6_377_019.27, 1.0 / 300.0;
    /// Helmert 1906 (EPSG:7020): a = 6 378 200 m, 1/f = 298.3.
    HELMERT1906 "helmert1906" 6_378_200.0, 1.0 / 298.3;
    /// War Office 1924 (EPSG:7029): a = 6 378 300 m, 1/f = 296.
    WAR_OFFICE "war-office" 6_378_300.0, 1.0 / 296.0;
    /// Krassovsky (Krassowsky) 1940 (EPSG:7024): a = 6 378 245 m, 1/f = 298.3.
    KRASSOVSKY1940 "krassovsky1940" 6_378_245.0, 1.0 / 298.3;
    /// Hough 1960 (EPSG:7053): a = 6 378 270 m, 1/f = 297.
    HOUGH1960 "hough1960" 6_378_270.0, 1.0 / 297.0;
    /// World Geodetic System 1960 (PROJ's `WGS60`): a = 6 378 165 m, 1/f = 298.3.
    WGS60 "wgs60" 6_378_165.0, 1.0 / 298.3;
    /// World Geodetic System 1966, also NWL 9D (EPSG:7025): a = 6 378 145 m, 1/f = 298.25.
    WGS66 "wgs66" 6_378_145.0, 1.0 / 298.25;
    /// Australian National Spheroid (EPSG:7003): a = 6 378 160 m, 1/f = 298.25.
    AUSTRALIAN_NATIONAL "australian-national" 6_378_160.0, 1.0 / 298.25;
    /// Geodetic Reference System 1967 (EPSG:7036): a = 6 378 160 m, 1/f = 298.247167427.
    GRS67 "grs67" 6_378_160.0, 1.0 / 298.247_167_427;
    /// GRS 1967 modified, of South America (SAD69, EPSG:7050): a = 6 378 160 m, 1/f = 298.25.
    GRS67_MODIFIED "grs67-modified" 6_378_160.0, 1.0 / 298.25;
    /// World Geodetic System 1972 (EPSG:7043): a = 6 378 135 m, 1/f = 298.26.
    WGS72 "wgs72" 6_378_135.0, 1.0 / 298.26;
    /// Indonesian National Spheroid 1974 (EPSG:7021): a = 6 378 160 m, 1/f = 298.247.
    INDONESIAN_NATIONAL "indonesian-national" 6_378_160.0, 1.0 / 298.247;
    /// IAG 1975, of China's Xian 1980 (EPSG:7049): a = 6 378 140 m, 1/f = 298.257.
    IAG1975 "iag1975" 6_378_140.0, 1.0 / 298.257;
    /// Average Terrestrial System 1977 (EPSG:7041): a = 6 378 135 m, 1/f = 298.257.
    AVERAGE_TERRESTRIAL1977 "average-terrestrial1977" 6_378_135.0, 1.0 / 298.257;
    /// Hughes 1980, of maps of sea ice (EPSG:7058): a = 6 378 273 m, b = 6 356 889.449 m.
    HUGHES1980 "hughes1980" 6_378_273.0, 21_383.551 / 6_378_273.0;
    /// PZ-90, of GLONASS (EPSG:7054): a = 6 378 136 m, 1/f = 298.257839303.
    PZ90 "pz90" 6_378_136.0, 1.0 / 298.257_839_303;
    /// GSK-2011, of Russia (EPSG:1025): a = 6 378 136.5 m, 1/f = 298.2564151.
    GSK2011 "gsk2011" 6_378_136.5, 1.0 / 298.256_415_1;
    /// CGCS2000, of China (EPSG:1024): the size and shape of [`GRS80`](Self::GRS80).
    CGCS2000 "cgcs2000" 6_378_137.0, 1.0 / 298.257_222_101;
    /// GRS 1980 Authalic Sphere, of global grids of equal area (EPSG:7048): a sphere of 6371.007 km.
    GRS80_AUTHALIC_SPHERE "grs80-authalic-sphere" 6_371_007.0, 0.0;
    /// The Sun (IAU 2015): a sphere of 695 700 km.
    SUN "sun" 695_700_000.0, 0.0;
    /// Mercury (IAU 2015): a = 2440.53 km, b = 2438.26 km.
    MERCURY "mercury" 2_440_530.0, 2_270.0 / 2_440_530.0;
    /// Venus (IAU 2015): a sphere of 6051.8 km.
    VENUS "venus" 6_051_800.0, 0.0;
    /// The Moon (IAU 2015): a sphere of 1737.4 km.
    MOON "moon" 1_737_400.0, 0.0;
    /// Mars (IAU 2015): a = 3396.19 km, b = 3376.2 km, 1/f = 169.8944472.
    MARS "mars" 3_396_190.0, 1.0 / 169.894_447_2;
    /// Phobos (IAU 2015): the sphere of its mean radius, 11.08 km.
    PHOBOS "phobos" 11_080.0, 0.0;
    /// Deimos (IAU 2015): the sphere of its mean radius, 6.2 km.
    DEIMOS "deimos" 6_200.0, 0.0;
    /// Ceres (IAU 2015): a = 487.3 km, b = 446 km.
    CERES "ceres" 487_300.0, 41_300.0 / 487_300.0;
    /// Jupiter at one bar (IAU 2015): a = 71 492 km, b = 66 854 km.
    JUPITER "jupiter" 71_492_000.0, 4_638_000.0 / 71_492_000.0;
    /// Io (IAU 2015): the sphere of its mean radius, 1821.49 km.
    IO "io" 1_821_490.0, 0.0;
    /// Europa (IAU 2015): the sphere of its mean radius, 1560.8 km.
    EUROPA "europa" 1_560_800.0, 0.0;
    /// Ganymede (IAU 2015): a sphere of 2631.2 km.
    GANYMEDE "ganymede" 2_631_200.0, 0.0;
    /// Callisto (IAU 2015): a sphere of 2410.3 km.
    CALLISTO "callisto" 2_410_300.0, 0.0;
    /// Saturn at one bar (IAU 2015): a = 60 268 km, b = 54 364 km.
    SATURN "saturn" 60_268_000.0, 5_904_000.0 / 60_268_000.0;
    /// Mimas (IAU 2015): the sphere of its mean radius, 198.2 km.
    MIMAS "mimas" 198_200.0, 0.0;
    /// Enceladus (IAU 2015): the sphere of its mean radius, 252.1 km.
    ENCELADUS "enceladus" 252_100.0, 0.0;
    /// Tethys (IAU 2015): the sphere of its mean radius, 531 km.
    TETHYS "tethys" 531_000.0, 0.0;
    /// Dione (IAU 2015): the sphere of its mean radius, 561.4 km.
    DIONE "dione" 561_400.0, 0.0;
    /// Rhea (IAU 2015): the sphere of its mean radius, 763.5 km.
    RHEA "rhea" 763_500.0, 0.0;
    /// Titan (IAU 2015): the sphere of its mean radius, 2575 km.
    TITAN "titan" 2_575_000.0, 0.0;
    /// Iapetus (IAU 2015): a = 745.7 km, b = 712.1 km.
    IAPETUS "iapetus" 745_700.0, 33_600.0 / 745_700.0;
    /// Uranus at one bar (IAU 2015): a = 25 559 km, b = 24 973 km.
    URANUS "uranus" 25_559_000.0, 586_000.0 / 25_559_000.0;
    /// Miranda (IAU 2015): the sphere of its mean radius, 235.8 km.
    MIRANDA "miranda" 235_800.0, 0.0;
    /// Ariel (IAU 2015): the sphere of its mean radius, 578.9 km.
    ARIEL "ariel" 578_900.0, 0.0;
    /// Umbriel (IAU 2015): a sphere of 584.7 km.
    UMBRIEL "umbriel" 584_700.0, 0.0;
    /// Titania (IAU 2015): a sphere of 788.9 km.
    TITANIA "titania" 788_900.0, 0.0;
    /// Oberon (IAU 2015): a sphere of 761.4 km.
    OBERON "oberon" 761_400.0, 0.0;
    /// Neptune at one bar (IAU 2015): a = 24 764 km, b = 24 341 km.
    NEPTUNE "neptune" 24_764_000.0, 423_000.0 / 24_764_000.0;
    /// Triton (IAU 2015): a sphere of 1352.6 km.
    TRITON "triton" 1_352_600.0, 0.0;
    /// Pluto (IAU 2015): a sphere of 1188.3 km.
    PLUTO "pluto" 1_188_300.0, 0.0;
    /// Charon (IAU 2015): a sphere of 606 km.
    CHARON "charon" 606_000.0, 0.0;
}

impl<T: Real> FromStr for Ellipsoid<T> {
    type Err = UnknownEllipsoid;

    /// The same as [`Ellipsoid::named`].
    fn from_str(name: &str) -> Result<Self, UnknownEllipsoid> {
        Self::named(name)
    }
}

unknown!(UnknownEllipsoid, "ellipsoid", NAMED.iter());
