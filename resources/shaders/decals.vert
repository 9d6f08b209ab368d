// A square that covers the sphere of a decal in the image. Kinds as in DecalKind.
layout(location = 0) in vec4 centre;   // w: radius, m
layout(location = 1) in vec4 colour;   // sRGB and opacity
layout(location = 2) in vec4 details;  // kind; radius one step earlier minus now, m; seed
flat out vec4 sphere;
flat out vec4 projected;  // sRGB and opacity
flat out int kind;
flat out float seed;

void main() {
    int number = gl_VertexID % 6;
    vec2 corner = vec2(number == 1 || number == 2 || number == 4 ? 1.0 : -1.0,
                       number == 0 || number == 1 || number == 3 ? -1.0 : 1.0);
    sphere = vec4(centre.xyz, centre.w + (1.0 - edges.w) * details.y);
    projected = colour;
    kind = int(details.x);
    seed = details.z;
    vec3 apart = sphere.xyz - eye.xyz;
    float ratio = eye.w > 0.5 ? sphere.w * sphere.w / max(dot(apart, apart), 1e-6) : 0.0;
    float wide = sphere.w * inversesqrt(max(1.0 - ratio, 1e-6));  // of the cone around the sphere, at its centre
    vec3 forward = eye.w > 0.5 ? normalize(apart) : -back.xyz;
    vec3 across = normalize(cross(forward, up.xyz)), high = cross(across, forward);
    vec3 p = sphere.xyz + wide * (corner.x * across + corner.y * high);
    gl_Position = ratio < 0.9 ? clipFromScene * vec4(p, 1.0) : vec4(corner, 0.0, 1.0);
}
