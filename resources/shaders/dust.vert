// Puffs of dust that face the camera: each an instance of two triangles.
layout(location = 0) in vec4 place;   // w: radius, m
layout(location = 1) in vec4 then;    // where it was a step before, less where it is; w: opacity
layout(location = 2) in vec4 colour;  // sRGB; w: what its shape is told apart by, in [0, 1)
out vec2 corner;
out float eyeDistance;  // along the view, m
out float height;       // above the ground, m
flat out vec4 puffColour;
flat out float puffRadius;
flat out float puffTurn;

void main() {
    int number = gl_VertexID % 6;
    corner = vec2(number == 1 || number == 2 || number == 4 ? 1.0 : -1.0, number == 0 || number == 1 || number == 3 ? -1.0 : 1.0);
    vec3 p = place.xyz + (1.0 - edges.w) * then.xyz + place.w * (corner.x * right.xyz + corner.y * up.xyz);
    eyeDistance = dot(eye.xyz - p, back.xyz);
    height = p.y - ground.y;
    puffColour = vec4(colour.rgb, then.w);
    puffRadius = place.w;
    puffTurn = colour.w;
    gl_Position = clipFromScene * vec4(p, 1.0);
}
