/* K3, RR-3UPS: 50 additions and multiplications, 1 division and 1 root for each of the legs.
 *
 * The vertical axis turns the anchor of the base back instead of the platform's forward, so that
 * each angle touches one vector: c = Rz(-alpha) (b - h0 e_z) and p = Rx(beta) a, and the leg is
 * c - p. Half its square, E = (|c|^2 + |p|^2)/2 - c.p, has through c.p alone
 *   the gradient   g = (cx py - cy px, cy pz - cz py),
 *   the Hessian    H = [[cx px + cy py, -cx pz], [-cx pz, cy py + cz pz]],
 * and q q' = E' twice over gives J = g/q, q_dot = J w, J_dot = (H w - q_dot J)/q. */
#include <math.h>

void hand_k3(const double *in, double *out);

void hand_k3(const double *in, double *out) {
  const double sa = sin(in[0]), ca = cos(in[0]);
  const double sb = sin(in[1]), cb = cos(in[1]);
  const double wa = in[2], wb = in[3], h0 = in[4];

  for (int leg = 0; leg < 3; ++leg) {
    const double *const a = in + 5 + 3 * leg;
    const double *const b = in + 14 + 3 * leg;
    const double cx = ca * b[0] + sa * b[1];
    const double cy = ca * b[1] - sa * b[0];
    const double cz = b[2] - h0;
    const double px = a[0];
    const double py = cb * a[1] - sb * a[2];
    const double pz = sb * a[1] + cb * a[2];
    const double lx = cx - px, ly = cy - py, lz = cz - pz;
    const double q = sqrt(lx * lx + ly * ly + lz * lz);
    const double per_q = 1.0 / q;
    const double common = cy * py, mixed = cx * pz;
    const double ja = (cx * py - cy * px) * per_q;
    const double jb = (cy * pz - cz * py) * per_q;
    const double q_dot = ja * wa + jb * wb;

    out[leg] = q;
    out[3 + leg] = q_dot;
    out[6 + 2 * leg] = ja;
    out[7 + 2 * leg] = jb;
    out[12 + 2 * leg] = ((cx * px + common) * wa - mixed * wb - q_dot * ja) * per_q;
    out[13 + 2 * leg] = ((common + cz * pz) * wb - mixed * wa - q_dot * jb) * per_q;
  }
}
