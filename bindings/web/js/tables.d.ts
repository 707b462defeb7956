/** Semi-major axis in metres and flattening of the ellipsoids that have a name. */
export const ellipsoids: { readonly [name: string]: { a: number; f: number } };

/** The names of the projections. */
export const projections: readonly string[];

/** The names of the latitudes by which an ellipsoid becomes a sphere. */
export const shifts: readonly string[];
