uniform mat4 clipFromSceneOfLight;
uniform uint pattern;  // 0: all bodies; else each transparent one as often as it is opaque

// A number in [0, 1) of a body, for each pattern another. Source: Jarzynski, Olano, "Hash functions for GPU rendering",
// 2020 (PCG).
float chanceOfBody() {
    uint state = (uint(bodyIndex()) + 0x9e3779b9u * pattern) * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22u) ^ word) & 0xffffu) / 65536.0;
}

void main() {
    uvec4 appearance = appearanceOfBody();
    bool isThere = isShown(appearance) && (pattern == 0u || chanceOfBody() < opacityOf(appearance));
    gl_Position = isThere ? clipFromSceneOfLight * vec4(pointInScene(poseOfBody()), 1.0) : kClipped;
}
