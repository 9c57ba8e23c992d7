#include <stdio.h>
#include "roms/bsp/board.h"
#include "roms/bsp/csr.h"
#include "roms/light/mesh.h"
#include "roms/light/power.h"
#include "roms/raster/canvas.h"
#include "roms/solids/models.h"
#include "roms/solids/normals.h"

static struct object object; static struct mesh mesh; static struct mesh_view view;
static struct power_table table; static float depth[640*480]; static uint32_t pixels[640*480];
int main(void)
{
    object_torus(&object, 1, 0.5f, 32, 16, 0);
    object_normals(&object, NORMALS_ROUND);
    printf("%d\n", mesh_of_object(&mesh, &object));
    printf("%d %d\n", mesh.vertices, mesh.triangles);
    power_table(&table, 20);
    struct canvas c = {(uint8_t*)pixels, 640, 640, 480, 8, 1};
    struct depth_buffer d = {depth, 640, 480};
    struct lighting l = lighting_dark(0.2f);
    lighting_add(&l, (struct light){.kind=LIGHT_FAR,.at={-1,1,1},.intensity=1});
    struct material m = {0.5f,0.6f,0.4f,20,0,false};
    view.model = matrix4_identity();
    view.model.at[1][1]=view.model.at[2][2]=0.6f; view.model.at[1][2]=-0.8f; view.model.at[2][1]=0.8f;
    view.distance=6; view.x=320; view.y=240; view.dots_x=view.dots_y=140;
    for (int k = 0; k < 4; k++) {
        uint32_t t0=csr_read_minstret();
        canvas_clear(&c,0);
        uint32_t t1=csr_read_minstret();
        depth_clear(&d,0);
        uint32_t t2=csr_read_minstret();
        mesh_project(&mesh,&view);
        uint32_t t3=csr_read_minstret();
        struct shade s=shade_begin(&c,&d,16,48);
        s.lighting=&l;s.material=&m;s.power=&table;
        mesh_shade(&mesh,&view,&s,(enum shading)k);
        uint32_t t4=csr_read_minstret();
        printf("%s: clear %lu depth %lu project %lu shade %lu; triangles %lu covered %lu: %.2f a pixel; %.2f ms\n",shading_names[k],
          (unsigned long)(t1-t0),(unsigned long)(t2-t1),(unsigned long)(t3-t2),(unsigned long)(t4-t3),(unsigned long)s.triangles,(unsigned long)s.covered,
          (double)(t4-t3)/s.covered,(double)(t4-t0)/50000);
    }
    return 0;
}
