// A body on which marks are drawn, once more.
out vec3 localPoint;
out vec3 localNormal;
flat out vec4 orientation;

void main() {
    uvec4 appearance = appearanceOfBody();
    BodyPose pose = poseOfBody();
    localPoint = position;
    localNormal = normal;
    orientation = pose.orientation;
    gl_Position = isShown(appearance) ? clipFromScene * vec4(pointInScene(pose), 1.0) : kClipped;
}
