// Light, a ring or soot on the surfaces and the ground within a sphere.
uniform sampler2D depths;  // of the solid surfaces
flat in vec4 sphere;
flat in vec4 projected;
flat in int kind;
flat in float seed;
out vec4 pixel;

float random(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }
float noise(vec2 p) {
    vec2 cell = floor(p), part = smoothstep(0.0, 1.0, fract(p));
    return mix(mix(random(cell), random(cell + vec2(1.0, 0.0)), part.x),
               mix(random(cell + vec2(0.0, 1.0)), random(cell + vec2(1.0, 1.0)), part.x), part.y);
}

// Soot in blots that are drawn out away from the centre.
float soot(vec2 p) {
    float radial = length(p);
    vec2 along = p / max(radial, 1e-3);
    float rays = noise(7.0 * along + 17.0 * seed), blots = noise(4.0 * p + 31.0 * seed);
    float edge = 0.6 + 0.35 * rays;
    return (1.0 - smoothstep(0.25 * edge, edge, radial)) * (0.65 + 0.35 * blots);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float value = texelFetch(depths, at, 0).r, d;
    Sight sight = sightAt(gl_FragCoord.xy / viewport.xy);
    bool isGround = meetsGround(sight, d);
    bool isBody = value < 1.0 && (!isGround || viewDepthOf(value) < d);
    if (isBody) d = viewDepthOf(value);
    vec3 apart = (sight.from + d * sight.along - sphere.xyz) / sphere.w;
    vec3 n = vec3(0.0, 1.0, 0.0);
    if (isBody) n = cross(dFdx(apart), dFdy(apart));
    n /= max(length(n), 1e-9);
    float radial = length(apart), cover = 0.0;
    if (!(isBody || isGround) || radial >= 1.0) discard;
    if (kind == 0) {
        float facing = max(dot(n, -apart) / max(radial, 1e-3), 0.0);
        cover = (1.0 - radial) * (1.0 - radial) * (0.25 + 0.75 * facing);
    } else if (kind == 1) {
        float ring = smoothstep(0.55, 0.9, radial) * (1.0 - smoothstep(0.9, 1.0, radial));
        cover = ring * (0.6 + 0.4 * noise(6.0 * apart.xz + 31.0 * seed)) * smoothstep(0.5, 0.8, n.y);
    } else if (!isBody) {
        cover = soot(apart.xz);
    }
    vec3 arriving = diffuseSky(n) + 0.8 * max(keyDirection.y, 0.0) * keyLight.rgb;
    vec3 shown = kind == 1 ? displayed(linearOf(projected.rgb) * arriving) : projected.rgb;
    pixel = vec4(shown, projected.a * cover);
}
