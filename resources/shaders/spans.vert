// Strokes in the scene, as wide in the picture wherever they are: each an instance, and what strokes.frag draws. A line is two
// triangles; an arrow two more such lines; a box twelve.
uniform float ofBoxes;   // 1: from `from` to `to` along the axes
uniform float strength;  // of their opacity
layout(location = 0) in vec4 from;    // w: radius, points
layout(location = 1) in vec4 to;      // w: 1 for an arrow
layout(location = 2) in vec4 colour;  // sRGB and opacity
layout(location = 3) in vec4 then;    // where it was a step before, less where it is
out vec2 point;
flat out vec4 strokeEnds;
flat out vec4 strokeColour;
flat out float strokeRadius;

const vec4 kNowhere = vec4(2.0, 2.0, 2.0, 1.0);
const float kBarb = 4.5;       // of the radius
const float kNearer = 0.0025;  // of the way to the eye, so that what lies on a face is before it

// A little nearer to the eye; w > 0 before it.
vec4 clipOf(vec3 p) {
    p += (1.0 - edges.w) * then.xyz;
    return clipFromScene * vec4(eye.w > 0.5 ? mix(p, eye.xyz, kNearer) : p, 1.0);
}

// The ends of one of a box's edges: four along each axis.
void boxEdge(int edge, out vec3 a, out vec3 b) {
    int axis = edge / 4;
    vec3 high = vec3(0.0);
    high[(axis + 1) % 3] = float(edge & 1);
    high[(axis + 2) % 3] = float((edge >> 1) & 1);
    a = mix(from.xyz, to.xyz, high);
    high[axis] = 1.0;
    b = mix(from.xyz, to.xyz, high);
}

void main() {
    int part = gl_VertexID / 6, corner = gl_VertexID % 6;
    vec3 a = from.xyz, b = to.xyz;
    if (ofBoxes > 0.5) boxEdge(part, a, b);
    vec4 clipA = clipOf(a), clipB = clipOf(b);
    float insideA = clipA.z + clipA.w, insideB = clipB.z + clipB.w;  // of the near plane
    gl_Position = kNowhere;
    if ((insideA <= 0.0 && insideB <= 0.0) || (part > 0 && ofBoxes < 0.5 && to.w < 0.5)) return;
    if (insideA <= 0.0) clipA = mix(clipA, clipB, insideA / (insideA - insideB));
    if (insideB <= 0.0) clipB = mix(clipB, clipA, insideB / (insideB - insideA));
    vec3 deviceA = clipA.xyz / clipA.w, deviceB = clipB.xyz / clipB.w;
    vec2 pixelA = (0.5 + 0.5 * deviceA.xy) * picture.xy, pixelB = (0.5 + 0.5 * deviceB.xy) * picture.xy;
    float reach = length(pixelB - pixelA);
    vec2 along = reach > 1e-3 ? (pixelB - pixelA) / reach : vec2(1.0, 0.0);
    strokeRadius = from.w * picture.w;
    if (part > 0 && ofBoxes < 0.5) {  // a barb, from the tip back and aside
        if (reach < 2.0 * strokeRadius) return;
        float barb = min(kBarb * strokeRadius, 0.5 * reach);
        vec2 aside = vec2(-along.y, along.x) * (part == 1 ? 0.45 : -0.45);
        pixelA = pixelB + barb * (aside - along);
        deviceA.z = deviceB.z;
        along = normalize(pixelB - pixelA);
    }
    vec2 across = vec2(-along.y, along.x);
    bool isAtB = corner == 1 || corner == 2 || corner == 4;
    float side = corner == 0 || corner == 1 || corner == 3 ? -1.0 : 1.0;
    float wide = strokeRadius + 1.0;
    point = (isAtB ? pixelB + wide * along : pixelA - wide * along) + side * wide * across;
    strokeEnds = vec4(pixelA, pixelB);
    strokeColour = vec4(colour.rgb, colour.a * strength);
    gl_Position = vec4(2.0 * point / picture.xy - 1.0, isAtB ? deviceB.z : deviceA.z, 1.0);
}
