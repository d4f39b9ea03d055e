// Bodies are drawn as impostors: a polygon about the picture of an ellipsoid (Sigg, Weyrich, Botsch, Gross
// 2006, GPU-based ray-casting of quadratic surfaces), in which each pixel finds its point by intersecting its
// own ray with the ellipsoid. So outlines, cuts and depths are exact at any zoom. The polygon stands where the
// body is nearest to the camera: depths are greater, and what lies behind other bodies can be left out early.

const common_shader = `#version 300 es
precision highp float; precision highp int; precision highp sampler2D;
uniform mat4 projection;
uniform mat3 turn;      // scene to camera
uniform vec3 target;    // in the scene
uniform float distance_;
vec3 seen(vec3 point) { return turn * (point - target) - vec3(0.0, 0.0, distance_); }
`;

const body_vertex_shader = common_shader + `
layout(location = 0) in uint particle;
uniform sampler2D bodies;   // three texels each: centre and value; quaternion; semi-axes and scale
uniform sampler2D spheres;  // centre and radius in units of the scale
uniform int sphere_first, sphere_count; // 0: smooth
uniform vec3 shift;         // to an image
uniform int corners;        // of the polygon
flat out vec3 centre, row_x, row_y, row_z;
flat out float value;
flat out uint which;

vec4 body_texel(int k) { int n = 3 * int(particle) + k, w = textureSize(bodies, 0).x; return texelFetch(bodies, ivec2(n % w, n / w), 0); }

mat3 rotation(vec4 q) {
  float w = q.x, x = q.y, y = q.z, z = q.w;
  return mat3(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y),
              2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x),
              2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y));
}

// A corner of a polygon about the unit circle, in the order of a strip of triangles.
vec2 corner() {
  int k = (gl_VertexID & 1) == 0 ? gl_VertexID / 2 : corners - 1 - gl_VertexID / 2;
  float share = 3.14159265 / float(corners), angle = (2.0 * float(k) + 1.0) * share;
  return vec2(cos(angle), sin(angle)) * (1.0005 / cos(share));
}

// The polygon about the body's outline, which is an ellipse: the dual conic is that of all planes through the
// camera that touch the body. Of bodies that reach around the camera: the whole picture.
vec2 about_outline(mat4 rows, mat3 axes) {
  vec4 at = vec4(centre, 1.0);
  float w = dot(rows[3], at);
  vec3 u = rows[0].xyz * axes, v = rows[1].xyz * axes, t = rows[3].xyz * axes;
  float a = w * w - dot(t, t);
  if (a <= 0.0) return 1.5 * corner();
  if (w <= 0.0) return vec2(2.0); // behind the camera
  vec2 place = vec2(dot(rows[0], at), dot(rows[1], at)) / w;
  u -= place.x * t; v -= place.y * t;
  vec2 b = -vec2(dot(u, t), dot(v, t)) / a;
  float xx = b.x * b.x + dot(u, u) / a, xy = b.x * b.y + dot(u, v) / a, yy = b.y * b.y + dot(v, v) / a;
  float l = sqrt(xx), m = l > 0.0 ? xy / l : 0.0;
  vec2 c = corner();
  return place + b + vec2(l * c.x, m * c.x + sqrt(max(0.0, yy - m * m)) * c.y);
}

// The least depth of the body, -1 to 1.
float nearest_depth(mat4 rows, mat3 axes) {
  float z = centre.z + length(vec3(axes[0].z, axes[1].z, axes[2].z)), w = rows[3].z * z + rows[3].w;
  return w > 0.0 ? clamp((rows[2].z * z + rows[2].w) / w - 4e-6, -1.0, 0.999) : -1.0;
}

void main() {
  vec4 first = body_texel(0);
  vec3 size = body_texel(2).xyz;
  mat3 body = rotation(body_texel(1));
  vec3 middle = first.xyz;
  if (sphere_count > 0) {
    int n = sphere_first + gl_InstanceID % sphere_count, w = textureSize(spheres, 0).x;
    vec4 sphere = texelFetch(spheres, ivec2(n % w, n / w), 0);
    float scale = body_texel(2).w;
    middle += body * (sphere.xyz * scale);
    size = vec3(sphere.w * scale);
  }
  centre = seen(middle + shift);
  value = first.w;
  which = particle;
  mat3 axes = turn * body;
  vec3 inverse = 1.0 / size;
  row_x = axes[0] * inverse.x; row_y = axes[1] * inverse.y; row_z = axes[2] * inverse.z;
  axes = mat3(axes[0] * size.x, axes[1] * size.y, axes[2] * size.z);
  mat4 rows = transpose(projection);
  gl_Position = vec4(about_outline(rows, axes), nearest_depth(rows, axes), 1.0);
}`;

const body_fragment_shader = common_shader + `
flat in vec3 centre, row_x, row_y, row_z;
flat in float value;
flat in uint which;
uniform vec2 pixels;              // of the picture
uniform vec3 cut_low, cut_high;  // in the scene
uniform bool cutting;
uniform vec2 colour_range;
uniform sampler2D colours;
uniform bool by_kind, picking;
uniform uint selected;           // place of a particle in its frame + 1
DEPTH_GREATER
out vec4 colour;

vec3 in_body(vec3 v) { return vec3(dot(row_x, v), dot(row_y, v), dot(row_z, v)); }

vec3 body_colour() {
  if (value < -1e29) return vec3(0.6);
  if (by_kind) return texelFetch(colours, ivec2(int(value + 0.5) % textureSize(colours, 0).x, 0), 0).rgb;
  float share = clamp((value - colour_range.x) / max(1e-30, colour_range.y - colour_range.x), 0.0, 1.0);
  return texture(colours, vec2((share * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

void main() {
  bool through_eye = projection[3][3] == 0.0;
  vec2 slope = (2.0 * gl_FragCoord.xy / pixels - 1.0) / vec2(projection[0][0], projection[1][1]);
  vec3 start = through_eye ? vec3(0.0) : vec3(slope, 0.0);
  vec3 ray = through_eye ? vec3(slope, -1.0) : vec3(0.0, 0.0, -1.0);
  float nearest = dot(centre - start, ray) / dot(ray, ray);
  vec3 o = in_body(start + ray * nearest - centre), d = in_body(ray);
  float dd = dot(d, d), middle = -dot(o, d) / dd;
  vec3 m = o + middle * d;
  float inside = 1.0 - dot(m, m);
  if (inside < 0.0) discard;
  float half_chord = sqrt(inside / dd);
  float enter = nearest + middle - half_chord, leave = nearest + middle + half_chord;
  vec3 normal = vec3(0.0);
  for (int k = 0; cutting && k < 3; ++k) {   // the part of the chord that is not cut off
    vec3 axis = turn[k];
    float at = dot(axis, start + vec3(0.0, 0.0, distance_)) + target[k], along = dot(axis, ray);
    if (abs(along) < 1e-9) {
      if (at < cut_low[k] || at > cut_high[k]) discard;
      continue;
    }
    float one = (cut_low[k] - at) / along, other = (cut_high[k] - at) / along;
    float first = min(one, other);
    if (first > enter) { enter = first; normal = along > 0.0 ? -axis : axis; }
    leave = min(leave, max(one, other));
  }
  if (through_eye && enter < 0.0) discard;
  if (enter >= leave) discard;
  vec3 point = start + ray * enter;
  bool is_cut = normal != vec3(0.0);
  if (!is_cut) {
    vec3 p = in_body(point - centre);
    normal = normalize(row_x * p.x + row_y * p.y + row_z * p.z);
  }
  float w = through_eye ? -point.z : 1.0;
  gl_FragDepth = 0.5 + 0.5 * (projection[2][2] * point.z + projection[3][2]) / w;
  if (picking) {
    uint n = which + 1u;
    colour = vec4(float(n & 255u), float((n >> 8) & 255u), float((n >> 16) & 255u), float(n >> 24)) / 255.0;
    return;
  }
  float light = 0.42 + 0.58 * max(0.0, dot(normal, normalize(vec3(-0.35, 0.55, 0.76))));
  if (is_cut) light *= 0.82;
  vec3 paint = which + 1u == selected ? mix(body_colour(), vec3(1.0, 0.25, 0.15), 0.75) : body_colour();
  colour = vec4(paint * light, 1.0);
}`;

const plain_vertex_shader = common_shader + `
layout(location = 0) in vec3 position;
out vec3 seen_at;
void main() { seen_at = seen(position); gl_Position = projection * vec4(seen_at, 1.0); }`;

const plain_fragment_shader = common_shader + `
in vec3 seen_at;
uniform vec4 paint;
uniform bool shaded;
out vec4 colour;
void main() {
  float light = 1.0;
  if (shaded) light = 0.55 + 0.45 * abs(normalize(cross(dFdx(seen_at), dFdy(seen_at))).z);
  colour = vec4(paint.rgb * light, paint.a);
}`;

// A ribbon that faces the camera from one end to the other.
const chain_vertex_shader = common_shader + `
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in float half_width;
void main() {
  vec3 a = seen(from), b = seen(to);
  vec3 along = b - a, side = vec3(-along.y, along.x, 0.0);
  float l = length(side);
  side = l > 0.0 ? side / l * half_width : vec3(half_width, 0.0, 0.0);
  vec3 p = ((gl_VertexID & 1) == 0 ? a : b) + ((gl_VertexID & 2) == 0 ? -side : side);
  gl_Position = projection * vec4(p, 1.0);
  gl_Position.z -= 0.02 * gl_Position.w;
}`;
