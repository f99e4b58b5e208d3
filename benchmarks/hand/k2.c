/* K2, heliostat: 54 additions and multiplications, 2 divisions, 2 roots.
 *
 * 1. Only the direction of b + c matters to the angles, so the sum is turned into the base frame
 *    as it is and scaled at the end. A turn keeps its length, so the horizontal part that the
 *    elevation needs is also most of the length.
 * 2. The base is three turns, applied to a vector one by one: no matrix is formed.
 * 3. When a frame turns about a unit axis a, a fixed vector moves by -a x n in it. Of n only the
 *    bearing (sin, cos of the azimuth) and the slope t = tan(elevation) enter:
 *      d azimuth = a_z - t (a_x sin + a_y cos),   d elevation = a_y sin - a_x cos.
 *    The three axes, in the base frame, are X, then Y seen through Rx(theta), then Z seen
 *    through Ry(psi) Rx(theta). */
#include <math.h>

void hand_k2(const double *in, double *out);

void hand_k2(const double *in, double *out) {
  const double sin_h = sin(in[0]), cos_h = cos(in[0]);
  const double sin_d = sin(in[1]), cos_d = cos(in[1]);
  const double sin_l = sin(in[2]), cos_l = cos(in[2]);
  const double st = sin(in[6]), ct = cos(in[6]);
  const double sp = sin(in[7]), cp = cos(in[7]);
  const double sc = sin(in[8]), cc = cos(in[8]);

  /* b + c, east north up */
  const double meridian = cos_d * cos_h;
  const double e = in[3] - cos_d * sin_h;
  const double n = in[4] + (sin_d * cos_l - meridian * sin_l);
  const double u = in[5] + (sin_d * sin_l + meridian * cos_l);

  /* into the base frame: Rz(-chi), Ry(-psi), Rx(-theta) */
  const double e1 = cc * e + sc * n;
  const double n1 = cc * n - sc * e;
  const double u2 = sp * e1 + cp * u;
  const double x = cp * e1 - sp * u;
  const double y = ct * n1 + st * u2;
  const double z = ct * u2 - st * n1;

  const double level_squared = x * x + y * y;
  const double level = sqrt(level_squared);
  const double per_level = 1.0 / level;
  const double per_length = 1.0 / sqrt(level_squared + z * z);

  const double s = x * per_level, c = y * per_level, t = z * per_level;
  const double ts = t * s, tc = t * c;
  const double chi_y = st * cp;

  out[0] = x * per_length;
  out[1] = y * per_length;
  out[2] = z * per_length;
  out[3] = atan2(x, y);
  out[4] = atan2(z, level);
  out[5] = -ts;
  out[6] = -(st + ct * tc);
  out[7] = ct * cp + sp * ts - chi_y * tc;
  out[8] = -c;
  out[9] = ct * s;
  out[10] = chi_y * s + sp * c;
}
