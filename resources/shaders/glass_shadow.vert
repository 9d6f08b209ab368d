uniform mat4 clipFromSceneOfLight;
flat out float passed;

void main() {
    uvec4 appearance = appearanceOfBody();
    passed = 1.0 - opacityOf(appearance);
    gl_Position = isShown(appearance) ? clipFromSceneOfLight * vec4(pointInScene(poseOfBody()), 1.0) : kClipped;
}
