out vec4 pixel;

void main() {
    vec3 shaded = shadedSurface();
    pixel = vec4(srgbOf(mix(shaded, shaded * kEdgeShade, edgeCover())), 1.0);
}
