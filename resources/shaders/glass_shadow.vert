uniform mat4 clipFromSceneOfLight;
flat out vec2 passed;  // by a surface that was outside, by a fracture surface

void main() {
    uvec4 appearance = appearanceOfBody();
    float left = 1.0 - opacityOf(appearance);
    passed = side == kInside ? vec2(1.0, left) : vec2(left, 1.0);
    gl_Position = isShown(appearance) ? clipFromSceneOfLight * vec4(pointInScene(poseOfBody()), 1.0) : kClipped;
}
