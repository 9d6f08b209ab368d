flat out uint body;

void main() {
    bool isHidden = (appearanceOfBody().z & kHidden) != 0u;
    body = uint(bodyIndex()) + 1u;
    gl_Position = isHidden ? kClipped : clipFromScene * vec4(pointInScene(poseOfBody()), 1.0);
}
