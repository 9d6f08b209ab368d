out vec3 scenePoint;
out vec3 sceneNormal;
out vec2 placeAcross;
flat out vec3 colour;  // sRGB
flat out uint marks;
flat out uint heat;

vec3 unpackedColour(uint rgb) { return vec3((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u) / 255.0; }

void main() {
    uvec4 look = lookOfBody();
    BodyPose pose = poseOfBody();
    scenePoint = pointInScene(pose);
    sceneNormal = turned(pose.orientation, normal);
    placeAcross = across;
    colour = unpackedColour(side == 0u ? look.x : look.y);
    marks = look.z;
    heat = look.w;
    gl_Position = (look.z & kHidden) != 0u ? kNowhere : clipFromScene * vec4(scenePoint, 1.0);
}
