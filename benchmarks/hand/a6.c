/* A6, geometric Jacobian of the six-axis arm: 59 additions and multiplications.
 *
 * The shoulder and the elbow turn about parallel axes, so the forearm's slope is one angle,
 * q2 + q3. Everything up to the wrist lies in the plane of the arm; only the wrist's axes leave
 * it, and only they are turned by q1 as full vectors.
 * The axes of the wrist meet, so its columns need the tool t alone, and as axis 4 x axis 6 is
 * sin(q5) times axis 5, column 4 is axis 5 again, scaled. */
#include <math.h>

void hand_a6(const double *in, double *out);

void hand_a6(const double *in, double *out) {
  const double s1 = sin(in[0]), c1 = cos(in[0]);
  const double s2 = sin(in[1]), c2 = cos(in[1]);
  const double forearm = in[1] + in[2];
  const double s3 = sin(forearm), c3 = cos(forearm);
  const double s4 = sin(in[3]), c4 = cos(in[3]);
  const double s5 = sin(in[4]), c5 = cos(in[4]);
  const double a2 = in[7], a3 = in[8], d6 = in[9];
  double *const angular = out + 18;

  /* axes 4, 5 and 6: first in the plane of the arm (reach, side, up), then in the base frame */
  const double x4 = c1 * c3, y4 = s1 * c3, z4 = -s3;
  const double r5 = s3 * s4, z5 = c3 * s4;
  const double x5 = c1 * r5 - s1 * c4, y5 = s1 * r5 + c1 * c4;
  const double side6 = s4 * s5, tilt = c4 * s5;
  const double r6 = c3 * c5 - s3 * tilt, z6 = -(s3 * c5 + c3 * tilt);
  const double x6 = c1 * r6 - s1 * side6, y6 = s1 * r6 + c1 * side6;

  /* the tool seen from the wrist, and the wrist seen from elbow and shoulder */
  const double tx = d6 * x6, ty = d6 * y6, tz = d6 * z6, tr = d6 * r6;
  const double elbow_r = a2 * s2, elbow_z = a2 * c2;
  const double wrist_r = a3 * c3, wrist_z = -(a3 * s3);
  const double from_elbow_r = tr + wrist_r, from_elbow_z = tz + wrist_z;
  const double reach = elbow_r + wrist_r;
  const double px = c1 * reach + tx, py = s1 * reach + ty;
  const double height = elbow_z + from_elbow_z;
  const double swing = d6 * s5;

  out[0] = -py;
  out[1] = c1 * height;
  out[2] = c1 * from_elbow_z;
  out[3] = swing * x5;
  out[4] = y5 * tz - z5 * ty;
  out[5] = 0.0;
  out[6] = px;
  out[7] = s1 * height;
  out[8] = s1 * from_elbow_z;
  out[9] = swing * y5;
  out[10] = z5 * tx - x5 * tz;
  out[11] = 0.0;
  out[12] = 0.0;
  out[13] = -(elbow_r + from_elbow_r);
  out[14] = -from_elbow_r;
  out[15] = swing * z5;
  out[16] = x5 * ty - y5 * tx;
  out[17] = 0.0;

  angular[0] = 0.0;
  angular[1] = -s1;
  angular[2] = -s1;
  angular[3] = x4;
  angular[4] = x5;
  angular[5] = x6;
  angular[6] = 0.0;
  angular[7] = c1;
  angular[8] = c1;
  angular[9] = y4;
  angular[10] = y5;
  angular[11] = y6;
  angular[12] = 1.0;
  angular[13] = 0.0;
  angular[14] = 0.0;
  angular[15] = z4;
  angular[16] = z5;
  angular[17] = z6;
}
