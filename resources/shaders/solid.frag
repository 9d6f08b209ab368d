out vec4 pixel;

const float kSunk = 0.6;  // opacity of the ground over what lies below it

void main() {
    vec3 shaded = shadedSurface(surfaceHere());
    shaded = mix(shaded, shaded * kEdgeShade, edgeCover());
    bool isSunk = spacing.z > 0.5 && scenePoint.y < ground.y && dot(back.xyz, vec3(0.0, 1.0, 0.0)) > 0.0;
    if (isSunk) shaded = mix(shaded, soil.rgb, kSunk);
    pixel = vec4(displayed(shaded), 1.0);
}
