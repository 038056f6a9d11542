// Longitude and latitude to metres about a point: an orthographic projection of the WGS84 ellipsoid onto the plane that touches
// it there. Lengths are right to 1e-7 within 2 km and to 1e-4 within 80 km.

import type { GroundPoint } from '../plane';

/** Of WGS84: the equator's radius [m], and the square of the eccentricity. */
const kRadius = 6378137;
const kFlattening = 1 / 298.257223563;
const kEccentric = kFlattening * (2 - kFlattening);

const radians = (degrees: number): number => (degrees * Math.PI) / 180;

/** From the earth's middle [m], at the height of the ellipsoid. */
function earthPoint(longitude: number, latitude: number): readonly [number, number, number] {
  const [a, b] = [radians(longitude), radians(latitude)];
  const across = kRadius / Math.sqrt(1 - kEccentric * Math.sin(b) ** 2);
  return [
    across * Math.cos(b) * Math.cos(a),
    across * Math.cos(b) * Math.sin(a),
    across * (1 - kEccentric) * Math.sin(b),
  ];
}

/** A function of longitude and latitude [degrees]: metres to the east and to the north of the middle. */
export function localMetres(middle: GroundPoint): (point: GroundPoint) => GroundPoint {
  const origin = earthPoint(middle.x, middle.y);
  const [a, b] = [radians(middle.x), radians(middle.y)];
  const east = [-Math.sin(a), Math.cos(a), 0] as const;
  const north = [-Math.sin(b) * Math.cos(a), -Math.sin(b) * Math.sin(a), Math.cos(b)] as const;
  return ({ x, y }) => {
    const at = earthPoint(x, y).map((one, k) => one - origin[k]!);
    const along = (axis: readonly number[]): number => axis.reduce((sum, one, k) => sum + one * at[k]!, 0);
    return { x: along(east), y: along(north) };
  };
}

/** How much the web's Mercator map stretches lengths at a northing of it [m]. */
export function mercatorStretch(northing: number): number {
  return Math.cosh(northing / kRadius);
}
