// Lights a surface, in one of three looks. What comes before this defines LOOK, 0: Course, 1: Studio,
// 2: Mannequin, and TEXTURED, 1 where the picture of the material takes part. Chosen by uniforms, software
// OpenGL would compute all looks and read a picture at every pixel.
in vec3 world_position;
in vec3 world_normal;
flat in vec3 face_normal;
in vec3 tint;
flat in vec3 copy_color;
in vec2 on_picture;

uniform vec3 color;
uniform float alpha;
// The picture of the material; stored values, as the color is.
uniform sampler2D picture;
// 1: one normal a triangle; 0: the interpolated one.
uniform int flat_normals;
uniform vec3 course_light;
uniform vec3 mannequin_light;
uniform vec3 eye;
uniform vec3 key_direction;
uniform vec3 fill_direction;
uniform vec3 rim_direction;

out vec4 fragment_color;

vec3 unit(vec3 v) {
    float squared = dot(v, v);
    return squared > 0.0 ? v * inversesqrt(squared) : vec3(0.0);
}

// The course's: Phong with one light. Its highlights are seen from the world's origin.
vec3 course(vec3 surface, vec3 n) {
    vec3 l = unit(course_light - world_position);
    vec3 v = unit(-world_position);
    float diffuse = max(dot(n, l), 0.0);
    float specular = pow(max(dot(v, reflect(-l, n)), 0.0), 32.0);
    return surface * (0.2 + 0.8 * diffuse) + vec3(0.4 * specular);
}

// Light adds up linearly, while colors are stored as the screen shows them.
vec3 linear_from_stored(vec3 stored) {
    return pow(stored, vec3(2.2));
}

// Light beyond what a screen shows is compressed instead of cut off, by its strongest color so that
// the others keep their proportion, and the more of it there is the whiter it becomes: a surface of a
// pure color keeps its shading. As Khronos' neutral tone mapping, but from a lower start on.
vec3 shown(vec3 light) {
    const float START = 0.4;
    const float WHITENING = 0.5;
    float peak = max(light.r, max(light.g, light.b));
    if (peak <= START) {
        return light;
    }
    const float RANGE = 1.0 - START;
    float compressed = 1.0 - RANGE * RANGE / (peak - START + RANGE);
    float kept = 1.0 / (1.0 + WHITENING * (peak - compressed));
    return mix(vec3(compressed), light * (compressed / peak), kept);
}

vec3 lit(vec3 surface, vec3 n, vec3 v, vec3 l, vec3 light, float shine) {
    float diffuse = max(dot(n, l), 0.0);
    float specular = pow(max(dot(n, unit(l + v)), 0.0), 48.0);
    return light * (surface * diffuse + vec3(shine * specular * step(0.0, dot(n, l))));
}

// Key, fill and rim light, a sky above and a ground below.
vec3 studio(vec3 stored, vec3 n) {
    vec3 surface = linear_from_stored(stored);
    vec3 v = unit(eye - world_position);
    if (dot(n, v) < 0.0) {
        n = -n;
    }
    vec3 sky = mix(vec3(0.10, 0.095, 0.09), vec3(0.26, 0.28, 0.31), 0.5 * n.y + 0.5);
    vec3 sum = surface * sky;
    sum += lit(surface, n, v, key_direction, vec3(0.95, 0.91, 0.85), 0.10);
    sum += lit(surface, n, v, fill_direction, vec3(0.20, 0.24, 0.30), 0.03);
    sum += lit(surface, n, v, rim_direction, vec3(0.42, 0.46, 0.52), 0.12);
    return pow(shown(sum), vec3(1.0 / 2.2));
}

// The color says where a surface looks; a picture is lit instead.
vec3 mannequin(vec3 surface, vec3 n) {
    if (TEXTURED == 1) {
        return surface * (0.15 + max(dot(n, unit(mannequin_light - world_position)), 0.0));
    }
    return 0.5 * n + 0.5;
}

vec3 seen(vec3 surface, vec3 n) {
#if LOOK == 0
    return course(surface, n);
#elif LOOK == 1
    return studio(surface, n);
#else
    return mannequin(surface, n);
#endif
}

void main() {
    vec3 n = unit(flat_normals == 1 ? face_normal : world_normal);
    vec3 surface = color * copy_color * tint;
    if (TEXTURED == 1) {
        surface *= texture(picture, on_picture).rgb;
    }
    fragment_color = vec4(seen(surface, n), alpha);
}
