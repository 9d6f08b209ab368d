out vec3 scenePoint;
out vec3 sceneNormal;
out vec2 placeAcross;
flat out vec3 colour;  // sRGB
flat out float opacity;
flat out uint marks;

vec3 unpackedColour(uint rgb) { return vec3((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u) / 255.0; }

void main() {
    uvec4 appearance = appearanceOfBody();
    BodyPose pose = poseOfBody();
    scenePoint = pointInScene(pose);
    sceneNormal = rotated(pose.orientation, normal);
    placeAcross = across;
    colour = unpackedColour(side == 0u ? appearance.x : appearance.y);
    opacity = opacityOf(appearance);
    marks = appearance.z;
    gl_Position = isShown(appearance) ? clipFromScene * vec4(scenePoint, 1.0) : kClipped;
}
