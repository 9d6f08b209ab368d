uniform mat4 clipFromSceneOfLight;
flat out float opacity;

void main() {
    uvec4 appearance = appearanceOfBody();
    opacity = opacityOf(appearance);
    gl_Position = isShown(appearance) ? clipFromSceneOfLight * vec4(pointInScene(poseOfBody()), 1.0) : kClipped;
}
