/* K1, two-axis pose and geometric Jacobian: 10 multiplications and 2 additions.
 *
 * Seen along the azimuth axis the tip sits at the distance r = L1 - L2 sin(nu); seen from the
 * elevation axis it sits at (up, back) = (L2 cos(nu), L2 sin(nu)). The pose's last column and the
 * Jacobian are these three lengths, turned by gamma; turning `r` gives two numbers that serve the
 * position and, crossed with the vertical, the first column. */
#include <math.h>

void hand_k1(const double *in, double *out);

void hand_k1(const double *in, double *out) {
  const double l0 = in[2], l1 = in[3], l2 = in[4];
  const double sg = sin(in[0]), cg = cos(in[0]);
  const double sn = sin(in[1]), cn = cos(in[1]);
  const double back = l2 * sn, up = l2 * cn;
  const double r = l1 - back;
  const double west = sg * r, north = cg * r;
  double *const jacobian = out + 16;

  out[0] = cg;
  out[1] = -(sg * cn);
  out[2] = sg * sn;
  out[3] = -west;
  out[4] = sg;
  out[5] = cg * cn;
  out[6] = -(cg * sn);
  out[7] = north;
  out[8] = 0.0;
  out[9] = sn;
  out[10] = cn;
  out[11] = l0 + up;
  out[12] = 0.0;
  out[13] = 0.0;
  out[14] = 0.0;
  out[15] = 1.0;

  jacobian[0] = -north;
  jacobian[1] = sg * up;
  jacobian[2] = -west;
  jacobian[3] = -(cg * up);
  jacobian[4] = 0.0;
  jacobian[5] = -back;
  jacobian[6] = 0.0;
  jacobian[7] = cg;
  jacobian[8] = 0.0;
  jacobian[9] = sg;
  jacobian[10] = 1.0;
  jacobian[11] = 0.0;
}
