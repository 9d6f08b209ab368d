uniform mat4 clipFromSceneOfLight;

void main() {
    bool isHidden = (appearanceOfBody().z & kHidden) != 0u;
    gl_Position = isHidden ? kClipped : clipFromSceneOfLight * vec4(pointInScene(poseOfBody()), 1.0);
}
