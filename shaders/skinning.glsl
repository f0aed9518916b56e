// Skeletal subspace deformation as character/skinning does it on the processor: every influence of
// a vertex, none dropped. Stands before the vertex shaders that move characters.

// For each character its place and color, then three cells a joint: the rows of the affine
// model_from_bind.
uniform sampler2D palettes;
// Two influences a cell: joint, weight, joint, weight.
uniform sampler2D influences;
// Where each of the characters that are drawn at once starts in the palettes.
uniform int instances[64];

// The rows of an affine matrix.
struct Rows {
    vec4 x;
    vec4 y;
    vec4 z;
};

// Both tables are 1024 cells wide, as render/skinning_tables.rs lays them out.
vec4 cell(sampler2D table, int index) {
    return texelFetch(table, ivec2(index & 1023, index >> 10), 0);
}

// Cells of a character before those of its joints: four for world_from_model, three for the same of
// normals, one for its color.
const int PLACE = 8;

mat4 world_from_model() {
    int at = instances[gl_InstanceID];
    return mat4(
        cell(palettes, at), cell(palettes, at + 1), cell(palettes, at + 2), cell(palettes, at + 3)
    );
}

mat3 world_from_model_normal() {
    int at = instances[gl_InstanceID] + 4;
    return mat3(cell(palettes, at).xyz, cell(palettes, at + 1).xyz, cell(palettes, at + 2).xyz);
}

vec3 own_color() {
    return cell(palettes, instances[gl_InstanceID] + 7).rgb;
}

void add_joint(inout Rows sum, float joint, float weight) {
    int row = instances[gl_InstanceID] + PLACE + 3 * int(joint);
    sum.x += weight * cell(palettes, row);
    sum.y += weight * cell(palettes, row + 1);
    sum.z += weight * cell(palettes, row + 2);
}

// The weighted sum of the joints that move a vertex. `run` says where its influences start and how
// many cells they take; a vertex without any stays at rest.
Rows model_from_bind(uvec2 run) {
    Rows sum = Rows(vec4(0.0), vec4(0.0), vec4(0.0));
    if (run.y == 0u) {
        sum.x.x = 1.0;
        sum.y.y = 1.0;
        sum.z.z = 1.0;
    }
    for (uint i = 0u; i < run.y; i++) {
        vec4 pair = cell(influences, int(run.x + i));
        add_joint(sum, pair.x, pair.y);
        // Runs of an odd number of influences end with a weight of zero.
        if (pair.w != 0.0) {
            add_joint(sum, pair.z, pair.w);
        }
    }
    return sum;
}

vec3 moved(Rows rows, vec3 bind) {
    vec4 at = vec4(bind, 1.0);
    return vec3(dot(rows.x, at), dot(rows.y, at), dot(rows.z, at));
}

vec3 unit_or(vec3 v, vec3 otherwise) {
    float squared = dot(v, v);
    return squared > 0.0 ? v * inversesqrt(squared) : otherwise;
}

// By the cofactors, the inverse transpose times the determinant: a sum of rotations is none.
vec3 turned(Rows rows, vec3 bind) {
    vec3 across_x = cross(rows.y.xyz, rows.z.xyz);
    vec3 across_y = cross(rows.z.xyz, rows.x.xyz);
    vec3 across_z = cross(rows.x.xyz, rows.y.xyz);
    return unit_or(vec3(dot(across_x, bind), dot(across_y, bind), dot(across_z, bind)), bind);
}
