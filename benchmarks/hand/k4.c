/* K4, RR-3UPS forces: per leg 1 division, 1 root and 6 trigonometric calls.
 *
 * 1. Axes that turn with the vertical one: only `theta - alpha` and the tilt are left. There the
 *    joint p moves by z x p as alpha turns and by x x p as beta does, which have a zero each, and
 *    velocity and acceleration of p are two columns that all legs share, times p.x and y.
 * 2. The leg is a particle on the sphere about its universal joint, with the joint's first axis e
 *    for pole. With s = w.e, c^2 = 1 - s^2, it has two directions of its own: X = w x e and
 *    Z = e - s w, both of length c. Nothing is divided by c: what acts along X and Z is kept
 *    times 1/c^2, and the spin, - (s/c^2) X.w', by itself.
 * 3. Of Newton's and Euler's laws for both links, whose angular velocity is the same, is left
 *      along X: (K + I_z + I_y tan^2) w'' + 2 k q' w' + gravity + 2 I_y (1 + tan^2) tan u_x u_z
 *      along Z: (K + I_x) w'' + 2 k q' w' + gravity - (I_x + I_y - I_z) tan u_x^2
 *      along w: m_s (w.P'' + s |w'|^2) + gravity
 *    with k = m_s (q - s), K = m_t t^2 + k (q - s) and I that of both links.
 * 4. The weight of a leg works by the height of P and by w.z alone, so it needs no axes.
 * 5. 1/q and 1/c^2 come of one division: by q^3 c^2.
 * 6. Least norm: with n = J_a x J_b, which does no work, F = (tau_a J_b - tau_b J_a) x n / n.n. */
#include <math.h>

void hand_k4(const double *in, double *out);

void hand_k4(const double *in, double *out) {
  const double *const I_t = in + 30, *const I_s = in + 39, *const I_m = in + 48;
  const double h_0 = in[51], m_m = in[52], g = in[56];
  const double *const r_sc = in + 53, *const n_d = in + 66;
  const double sa = sin(in[57]), ca = cos(in[57]);
  const double sb = sin(in[58]), cb = cos(in[58]);
  const double wa = in[59], wb = in[60], ea = in[61], eb = in[62];

  /* Of P'': x column (- wa^2, ea, 0), y column (y1, y2, y3). */
  const double waa = wa * wa, wbb = wb * wb, wab = 2 * (wa * wb);
  const double y1 = wab * sb - ea * cb;
  const double y2 = (waa + wbb) * cb + eb * sb;
  const double y3 = eb * cb - wbb * sb;
  const double g_cb = g * cb;

  /* Platform: Euler's equations, its weight and the moment on it. */
  const double excess = (I_m[1] - I_m[2]) * sb, mixed = excess * cb;
  double tau_a = ea * (I_m[2] + excess * sb) + wab * mixed - n_d[2];
  double tau_b = I_m[0] * eb - waa * mixed + m_m * (g_cb * r_sc[1] - g * (sb * r_sc[2]));
  tau_b -= ca * n_d[0] + sa * n_d[1];

  double J_a[3], J_b[3];
  for (int leg = 0; leg < 3; ++leg) {
    const double r = in[leg], phi = in[3 + leg], R = in[6 + leg], zeta = in[15 + leg];
    const double bearing = in[9 + leg] - in[57];
    const double t = in[18 + leg], s_p = in[21 + leg], m_t = in[24 + leg], m_s = in[27 + leg];

    const double px = r * cos(phi), y = r * sin(phi), py = cb * y, pz = sb * y;
    const double lx = px - R * cos(bearing), ly = py - R * sin(bearing);
    const double lz = pz - (in[12 + leg] - h_0);
    const double ez = cos(zeta), tip = sin(zeta), ex = ca * tip, ey = -sa * tip;

    const double qq = lx * lx + ly * ly + lz * lz, q = sqrt(qq);
    const double le = lx * ex + ly * ey + lz * ez;
    const double cc_qq = qq - le * le;
    const double inverse = 1.0 / (q * cc_qq);
    const double per_q = cc_qq * inverse, per_qcc = qq * inverse, per_cc = q * per_qcc;
    const double wx = lx * per_q, wy = ly * per_q, wz = lz * per_q, s = le * per_q;
    const double Xx = wy * ez - wz * ey, Xy = wz * ex - wx * ez, Xz = wx * ey - wy * ex;

    /* Of w, X and e: along the ways of P, along P', along P''. */
    const double w_a = wy * px - wx * py, w_b = wz * py - wy * pz;
    const double X_a = Xy * px - Xx * py, X_b = Xz * py - Xy * pz;
    const double e_a = ey * px - ex * py, e_b = ez * py - ey * pz;
    const double q_dot = w_a * wa + w_b * wb, rate = q_dot + q_dot;
    const double H = (X_a * wa + X_b * wb) * per_q;
    const double E = (e_a * wa + e_b * wb - s * q_dot) * per_q;
    const double ax = y1 * y - waa * px, ay = ea * px - y2 * y, az = y3 * y;
    const double wP = wx * ax + wy * ay + wz * az;
    const double XP = Xx * ax + Xy * ay + Xz * az;
    const double eP = ex * ax + ey * ay + ez * az;

    const double first = t * m_t, arm = q - s_p, k = arm * m_s, K = t * first + arm * k;
    const double I_x = I_t[3 * leg] + I_s[3 * leg];
    const double I_y = I_t[3 * leg + 1] + I_s[3 * leg + 1];
    const double I_z = I_t[3 * leg + 2] + I_s[3 * leg + 2];
    const double I_zy = I_z - I_y, tall = I_y * per_cc;
    const double spin = s * per_cc * H;
    const double coriolis_X = rate * H, coriolis_Z = rate * E;

    const double f_X =
        ((K + I_zy + tall) * ((XP - coriolis_X) * per_q) + k * coriolis_X + 2 * (tall * spin * E)) *
        per_qcc;
    const double f_Z = ((K + I_x) * ((eP - s * wP - coriolis_Z) * per_q) + k * coriolis_Z -
                        (I_x - I_zy) * spin * H) *
                       per_qcc;
    const double weight = (first + k) * per_q, gz = g * wz;
    const double f_w = m_s * (wP + gz + s_p * (per_cc * (H * H + E * E))) - weight * gz - s * f_Z;

    tau_a += f_X * X_a + f_Z * e_a + f_w * w_a;
    tau_b += f_X * X_b + f_Z * e_b + f_w * w_b + weight * (g_cb * y);
    J_a[leg] = w_a;
    J_b[leg] = w_b;
  }

  double idle[3], mixture[3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    idle[i] = J_a[j] * J_b[k] - J_a[k] * J_b[j];
    mixture[i] = tau_a * J_b[i] - tau_b * J_a[i];
  }
  const double scale = 1.0 / (idle[0] * idle[0] + idle[1] * idle[1] + idle[2] * idle[2]);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = (mixture[j] * idle[k] - mixture[k] * idle[j]) * scale;
  }
}
