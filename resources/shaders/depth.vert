uniform mat4 clipFromSceneOfLight;
uniform uint pattern;  // 0: all bodies; else each transparent one as often as it is opaque

// A number in [0, 1) of a body. Two successive patterns, whose light neighbouring pixels get, have the same one, and the
// pairs of all patterns spread evenly. Source: Jarzynski, Olano, "Hash functions for GPU rendering", 2020 (PCG).
float chanceOfBody() {
    uint state = uint(bodyIndex()) * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return fract(float(((word >> 22u) ^ word) & 0xffffu) / 65536.0 + 0.41421356 * float((pattern - 1u) / 2u));
}

void main() {
    uvec4 appearance = appearanceOfBody();
    bool isThere = isShown(appearance) && (pattern == 0u || chanceOfBody() < opacityOf(appearance));
    gl_Position = isThere ? clipFromSceneOfLight * vec4(pointInScene(poseOfBody()), 1.0) : kClipped;
}
