// tests/bench/bench_occt.cpp -- Open CASCADE's curves in a plane, callable from C, for
// bench_peers.c
// SPDX-License-Identifier: MIT
#include "bench_peers.h"

#include <GCPnts_QuasiUniformDeflection.hxx>
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2dAPI_ProjectPointOnCurve.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

static Handle(Geom2d_Curve) bezier(double p[4][2])
{
    TColgp_Array1OfPnt2d poles(1, 4);
    for (int k = 0; k < 4; k++)
        poles.SetValue(k + 1, gp_Pnt2d(p[k][0], p[k][1]));
    return new Geom2d_BezierCurve(poles);
}

extern "C" unsigned bench_occt_flat(double p[4][2], double tol, double (*out)[4])
{
    const Geom2dAdaptor_Curve curve(bezier(p));
    const GCPnts_QuasiUniformDeflection points(curve, tol);
    unsigned n = 0;

    for (int k = 2; points.IsDone() && k <= points.NbPoints() && n < MOST; k++) {
        out[n][0] = points.Value(k).X();
        out[n++][1] = points.Value(k).Y();
    }
    return n;
}

extern "C" unsigned bench_occt_near(double p[4][2], const double from[2], double (*out)[4])
{
    const Geom2dAPI_ProjectPointOnCurve nearest(gp_Pnt2d(from[0], from[1]), bezier(p));
    unsigned n = 0;

    for (int k = 1; k <= nearest.NbPoints() && n < MOST; k++)
        out[n++][0] = nearest.Parameter(k);
    // it knows only feet of perpendiculars: the ends are the caller's
    out[n++][0] = 0;
    out[n++][0] = 1;
    return n;
}

extern "C" unsigned bench_occt_cross(double a[4][2], double b[4][2], double tol,
                                     double (*out)[4])
{
    const Geom2dAPI_InterCurveCurve found(bezier(a), bezier(b), tol);
    unsigned n = 0;

    for (int k = 1; k <= found.NbPoints() && n < MOST; k++) {
        out[n][0] = found.Intersector().Point(k).ParamOnFirst();
        out[n++][1] = found.Intersector().Point(k).ParamOnSecond();
    }
    return n;
}

extern "C" unsigned bench_occt_spline(double p[][2], int points, const double knots[],
                                      int degree, const double u[], int count, double (*out)[4])
{
    const int spans = points - degree;
    TColgp_Array1OfPnt2d poles(1, points);
    TColStd_Array1OfReal knot(1, spans + 1);
    TColStd_Array1OfInteger times(1, spans + 1);

    for (int k = 0; k < points; k++)
        poles.SetValue(k + 1, gp_Pnt2d(p[k][0], p[k][1]));
    for (int k = 0; k <= spans; k++) {
        knot.SetValue(k + 1, knots[degree + k]);
        times.SetValue(k + 1, k == 0 || k == spans ? degree + 1 : 1);
    }
    const Handle(Geom2d_BSplineCurve) curve = new Geom2d_BSplineCurve(poles, knot, times, degree);
    for (int n = 0; n < count; n++) {
        gp_Pnt2d at;
        curve->D0(u[n], at);
        out[n][0] = at.X();
        out[n][1] = at.Y();
    }
    return (unsigned)count;
}
