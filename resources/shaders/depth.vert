uniform mat4 clipFromSceneOfLight;

void main() {
    bool isHidden = (lookOfBody().z & kHidden) != 0u;
    gl_Position = isHidden ? kNowhere : clipFromSceneOfLight * vec4(pointInScene(poseOfBody()), 1.0);
}
