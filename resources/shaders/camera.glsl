// From pixels back to the scene.

// The view depth of a value of the depth buffer, m.
float viewDepthOf(float value) {
    float device = 2.0 * value - 1.0;
    return eye.w > 0.5 ? depth.y / (device + depth.x) : (depth.y - device) / depth.x;
}

// A line of sight: a point of it at view depth d is `from + d * along`.
struct Sight {
    vec3 from;
    vec3 along;
};
// `place`: in [0, 1], of the image.
Sight sightAt(vec2 place) {
    vec2 aside = 2.0 * place - 1.0 - 2.0 * jitter.xy / viewport.xy;
    vec3 across = aside.x * right.w * right.xyz + aside.y * up.w * up.xyz;
    return eye.w > 0.5 ? Sight(eye.xyz, across - back.xyz) : Sight(eye.xyz + across, -back.xyz);
}

// Whether a line of sight meets the ground from above, and at which view depth. In parallel projection also behind the
// eye, which lies anywhere on it.
bool meetsGround(Sight sight, out float viewDepth) {
    float above = sight.from.y - ground.y;
    viewDepth = sight.along.y < 0.0 ? -above / sight.along.y : 0.0;
    return spacing.z > 0.5 && sight.along.y < 0.0 && (above > 0.0 || eye.w < 0.5);
}
