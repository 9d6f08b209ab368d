// A soft particle with a noisy edge, lit from above, that fades where it meets solid surfaces; or a splinter.
uniform sampler2D depths;  // of the solid surfaces
in vec2 corner;
in float eyeDistance;
in float height;
flat in vec4 puffColour;
flat in float puffRadius;
flat in float puffSeed;
out vec4 pixel;

float random(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453); }
float noise(vec2 p) {
    vec2 cell = floor(p), part = smoothstep(0.0, 1.0, fract(p));
    return mix(mix(random(cell), random(cell + vec2(1.0, 0.0)), part.x),
               mix(random(cell + vec2(0.0, 1.0)), random(cell + vec2(1.0, 1.0)), part.x), part.y);
}

const float kSlenderness = 4.0;  // of a splinter
const float kGlint = 16.0;       // exponent: it glints in few directions

float surfaceDepth() { return viewDepthOf(texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r); }

// A rhombus that rotates; at four rotations, its own ones, it reflects the light.
vec4 splinter(float turn) {
    float angle = 6.2831853 * turn;
    mat2 rotation = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    vec2 p = abs(rotation * corner);
    float inside = 1.0 - p.x - kSlenderness * p.y;
    float cover = clamp(inside / max(fwidth(inside), 1e-6) + 0.5, 0.0, 1.0);
    float glint = pow(abs(cos(2.0 * angle + 900.0 * puffRadius)), kGlint);
    bool isHidden = eyeDistance > surfaceDepth();
    return vec4(mix(puffColour.rgb * 0.8 * depth.w, vec3(1.0), glint),
                isHidden ? 0.0 : cover * puffColour.a * (0.45 + 0.55 * glint));
}

void main() {
    if (puffSeed >= 1.0) {
        pixel = splinter(puffSeed - 1.0);
        return;
    }
    float radial = length(corner);
    if (radial >= 1.0) discard;
    vec2 p = 1.7 * corner + 31.0 * puffSeed;
    float cloud = 0.65 * noise(p) + 0.35 * noise(2.3 * p + 5.0);
    float density = (1.0 - smoothstep(0.15, 1.0, radial)) * smoothstep(0.1, 0.7, cloud + 0.35 * (1.0 - radial));
    float thickness = max(puffRadius * sqrt(1.0 - radial * radial), 1e-4);  // of a sphere
    float soft = clamp(0.5 + 0.5 * (surfaceDepth() - eyeDistance) / thickness, 0.0, 1.0);
    float low = clamp(0.5 + height / puffRadius, 0.0, 1.0);
    float light = (0.80 + 0.16 * corner.y + 0.10 * (cloud - 0.5)) * depth.w;
    pixel = vec4(min(puffColour.rgb * light, vec3(1.0)), puffColour.a * density * soft * low);
}
