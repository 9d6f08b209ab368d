// Metal-rough shading: a diffuse base under a glossy layer of GGX facets, or a metal.

struct Surface {
    vec3 albedo;  // linear; of a metal what it reflects
    vec3 normal;
    float roughness;  // in [0, 1]; its square is the width of the facets' slopes
    float metalness;
    float occlusion;  // the part of the surroundings' light that small cavities let through
};

// Of the light from all around, the part that facets reflect once if their reflectance at normal incidence is 1 (x), and
// what remains of it if that is 0 (y): fits to the integrals of GGX facets with Smith's shadowing, in the manner of
// Karis, "Physically based shading on mobile", 2014; they differ from them by 0.02 in the mean.
vec2 environmentReflectance(float roughness, float facingEye) {
    float lost = 1.023 - 0.960 * roughness + facingEye * (2.039 - 0.692 * roughness) +
                 facingEye * facingEye * (1.217 * roughness - 1.946);
    float grazing = max(1.0 - 0.947 * roughness, 0.0);
    return vec2(1.0 - roughness * roughness * roughness * lost,
                grazing * grazing * exp2((1.439 * roughness - 7.503) * facingEye));
}

// Over all directions, of what reflects `f0` at normal incidence by Schlick's approximation.
float meanReflectance(float f0) { return mix(f0, 1.0, 1.0 / 21.0); }
vec3 meanReflectance(vec3 f0) { return mix(f0, vec3(1.0), 1.0 / 21.0); }

// The lobe of the key light: distribution times visibility times pi. Sources: Walter et al., "Microfacet models for
// refraction through rough surfaces", 2007; Hammon, "PBR diffuse lighting for GGX+Smith microsurfaces", 2017.
float keyLobe(float alpha, float facingHalf, float facingKey, float facingEye) {
    float square = alpha * alpha, width = facingHalf * facingHalf * (square - 1.0) + 1.0;
    float visibility = 0.5 / max(mix(2.0 * facingKey * facingEye, facingKey + facingEye, alpha), 1e-4);
    return square / (width * width) * visibility;
}

// The part of the light of a reflected lobe that reaches a surface of which `occlusion` of the sky is seen.
// Source: Lagarde, de Rousiers, "Moving Frostbite to physically based rendering", 2014.
float specularOcclusion(float facingEye, float occlusion, float roughness) {
    return clamp(pow(facingEye + occlusion, exp2(-16.0 * roughness - 1.0)) - 1.0 + occlusion, 0.0, 1.0);
}

const float kReflectance = 0.04;  // at normal incidence, of what is no metal
const float kInside = 0.1;  // the part of the sky's light that other surfaces bring to where none of it arrives directly

// The radiance of a surface towards the eye; `reached`: the parts of the sky's and of the key light that reach it.
// Light that facets reflect more than once: Fdez-Aguera, "A multiple-scattering microfacet model for real-time
// image-based lighting", 2019; for the key light: Turquin, "Practical multiple scattering compensation", 2019.
vec3 lit(Surface surface, vec3 toEye, vec2 reached) {
    vec3 n = surface.normal;
    float facingEye = clamp(dot(n, toEye), 1e-3, 1.0), facingKey = max(dot(n, keyDirection.xyz), 0.0);
    float sky = mix(kInside, 1.0, reached.x) * surface.occlusion, below = (0.35 + 0.65 * reached.x) * surface.occlusion;
    vec3 ground = groundLight.rgb * ((0.5 - 0.5 * n.y) * below);
    vec3 diffuse = diffuseSky(n) * sky + ground;

    vec3 f0 = mix(vec3(kReflectance), surface.albedo, surface.metalness);
    vec2 fit = environmentReflectance(surface.roughness, facingEye);
    float left = 1.0 - fit.x, layerOnce = mix(fit.y, fit.x, kReflectance), layerMean = meanReflectance(kReflectance);
    float layerOften = layerOnce * left * layerMean / (1.0 - left * layerMean);
    vec3 metalOnce = mix(vec3(fit.y), vec3(fit.x), surface.albedo), metalMean = meanReflectance(surface.albedo);
    vec3 once = mix(vec3(layerOnce), metalOnce, surface.metalness);
    vec3 often = mix(vec3(layerOften), metalOnce * left * metalMean / (1.0 - left * metalMean), surface.metalness);
    vec3 base = surface.albedo * ((1.0 - surface.metalness) * (1.0 - layerOnce - layerOften));

    vec3 mirror = reflect(-toEye, n);
    float seen = specularOcclusion(facingEye, mix(below, sky, clamp(mirror.y + 0.5, 0.0, 1.0)), surface.roughness);
    vec3 around = once * reflected(mirror, surface.roughness) * seen + (often + base) * diffuse;

    vec3 halfway = normalize(toEye + keyDirection.xyz);
    float alpha = min(surface.roughness * surface.roughness + 0.5 * keyDirection.w, 1.0);
    float lobe = keyLobe(alpha, max(dot(n, halfway), 0.0), facingKey, facingEye);
    float grazing = 1.0 - max(dot(toEye, halfway), 0.0), square = grazing * grazing;
    vec3 fresnel = f0 + (1.0 - f0) * (square * square * grazing);
    vec3 key = fresnel * lobe * (1.0 + f0 * (left / fit.x)) + base;
    return around + keyLight.rgb * (facingKey * reached.y) * key;
}
