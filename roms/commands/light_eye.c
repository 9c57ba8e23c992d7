/* light_eye.c — mach and halftone: what the eye makes of steps, and of few levels. */
#include <math.h>
#include <stdio.h>

#include "roms/commands/light.h"
#include "roms/scenery/eye.h"
#include "roms/monitor/print.h"

bool light_mach(struct monitor *m, struct words *w)
{
    static const char *const names[] = {"flat", "gouraud", NULL};
    int which, facets = 6;
    if (!words_choice(w, names, &which) ||
        (words_left(w) > 0 && !words_whole(w, 2, MACH_FACETS, &facets)) || !words_end(w))
        return false;
    struct eye_profile p;
    eye_profile_make(&p, facets, which == 1);
    if (m->table) {
        printf("facet      left    middle     right   seen: least      most\n");
        for (int i = 0; i < facets; i++) {
            struct eye_facet f = eye_facet(&p, i);
            printf("%5d %9.4f %9.4f %9.4f %13.4f %9.4f\n", i + 1, print_tidy(f.left),
                   print_tidy(f.middle), print_tidy(f.right), print_tidy(f.least),
                   print_tidy(f.most));
        }
    }
    printf("the eye sees at most %.4f more and %.4f less than there is\n", print_tidy(p.over),
           print_tidy(p.under));
    stage_begin(&m->stage);
    stage_title(&m->stage, which == 1 ? "Mach bands: Gouraud shading" : "Mach bands: flat shading");
    eye_mach_draw(&m->stage, &p);
    stage_caption(
        &m->stage,
        "Below: the intensity of the picture above (yellow), and what lateral inhibition makes "
        "of it (red).");
    stage_end(&m->stage);
    return true;
}

bool light_halftone(struct monitor *m, struct words *w)
{
    int levels, method;
    if (!words_whole(w, 2, 48, &levels) || !words_choice(w, dither_names, &method) || !words_end(w))
        return false;
    struct eye_means means = eye_halftone_means(levels, (enum dither_method)method);
    if (m->table) {
        printf("row      wanted     shown\n");
        for (int i = 0; i < EYE_BANDS; i++)
            printf("%3d %11.4f %9.4f\n", i + 1, print_tidy(means.wanted[i]),
                   print_tidy(means.shown[i]));
    }
    printf("mean intensity wanted %.4f, shown %.4f\n", print_tidy(means.all_wanted),
           print_tidy(means.all_shown));
    stage_begin(&m->stage);
    stage_title(&m->stage, dither_names[method]);
    eye_halftone_draw(&m->stage, 600, 400, 370, levels, (enum dither_method)method);
    stage_end(&m->stage);
    return true;
}
