out vec3 scenePoint;
out vec3 sceneNormal;
out vec2 placeAcross;
flat out vec3 colour;  // sRGB
flat out uint marks;

vec3 unpackedColour(uint rgb) { return vec3((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u) / 255.0; }

void main() {
    uvec4 appearance = appearanceOfBody();
    BodyPose pose = poseOfBody();
    scenePoint = pointInScene(pose);
    sceneNormal = rotated(pose.orientation, normal);
    placeAcross = across;
    colour = unpackedColour(side == 0u ? appearance.x : appearance.y);
    marks = appearance.z;
    gl_Position = (appearance.z & kHidden) != 0u ? kClipped : clipFromScene * vec4(scenePoint, 1.0);
}
