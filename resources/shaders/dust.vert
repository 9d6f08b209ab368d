// Dust billboards: an instance of two triangles each.
layout(location = 0) in vec4 centre;          // w: radius, m
layout(location = 1) in vec4 previousOffset;  // position one step earlier minus position now; w: opacity
layout(location = 2) in vec4 colour;          // sRGB; w: seed of its noise, in [0, 1), or 1 + turns of a splinter
out vec2 corner;
out float eyeDistance;  // view depth, m
out float height;       // above the ground, m
flat out vec4 puffColour;
flat out float puffRadius;
flat out float puffSeed;

void main() {
    int number = gl_VertexID % 6;
    corner = vec2(number == 1 || number == 2 || number == 4 ? 1.0 : -1.0,
                  number == 0 || number == 1 || number == 3 ? -1.0 : 1.0);
    vec3 p = centre.xyz + (1.0 - edges.w) * previousOffset.xyz + centre.w * (corner.x * right.xyz + corner.y * up.xyz);
    eyeDistance = dot(eye.xyz - p, back.xyz);
    height = p.y - ground.y;
    puffColour = vec4(colour.rgb, previousOffset.w);
    puffRadius = centre.w;
    puffSeed = colour.w;
    gl_Position = clipFromScene * vec4(p, 1.0);
}
