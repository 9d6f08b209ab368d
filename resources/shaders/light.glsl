// A texel of the light buffer: the parts of the sky's and of the key light that reach the nearest surface there (x, y),
// and the surface's view depth, m (z), and normal (w).

const float kGroundTexel = -1.0;  // in place of a normal

// Two components of a normal in an integer that a float holds exactly. Source: Meyer et al., "On floating-point normal
// vectors", 2010.
float packedNormal(vec3 n) {
    vec2 plane = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    if (n.z < 0.0) plane = (1.0 - abs(plane.yx)) * vec2(plane.x < 0.0 ? -1.0 : 1.0, plane.y < 0.0 ? -1.0 : 1.0);
    vec2 steps = floor(2047.0 * (0.5 * plane + 0.5) + 0.5);
    return steps.x + 2048.0 * steps.y;
}
// A direction; its length is between 0.57 and 1.
vec3 unpackedNormal(float number) {
    if (number == kGroundTexel) return vec3(0.0, 1.0, 0.0);
    float high = floor(number / 2048.0);
    vec2 plane = 2.0 * vec2(number - 2048.0 * high, high) / 2047.0 - 1.0;
    vec3 n = vec3(plane, 1.0 - abs(plane.x) - abs(plane.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    return n;
}

// The change of a surface's view depth from one texel to the next, m, seen along a unit direction.
float depthSlope(float viewDepth, vec3 n, vec3 sight) {
    float facing = max(abs(dot(n, sight)), 0.05);
    return jitter.w / pixelsPerMetre(viewDepth) * sqrt(1.0 - facing * facing) / facing;
}

// How much a texel says about a surface: little across edges and steps.
float likeness(vec4 texel, float viewDepth, float slope, vec3 n) {
    float apart = (texel.z - viewDepth) / (slope + 2.0 * jitter.w / pixelsPerMetre(viewDepth));
    float facing = max(dot(unpackedNormal(texel.w), n), 0.0);
    facing *= facing;
    facing *= facing;
    return facing * facing / (1.0 + apart * apart) + 1e-4;
}
