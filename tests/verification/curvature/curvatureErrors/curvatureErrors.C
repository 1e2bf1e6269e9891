/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    curvatureErrors

Description
    Errors of curvature, distance and normal of balls (on a 2D mesh discs) with
    the exact share of each cell. For each shape of system/shapesDict,

        shapes ( name { centre (0 0 0); radius 1; contactAngles {} } ... );

    (on a 2D periodic mesh with an entry image, the centre of the same disc one
    period away) one line: number of crossed cells; mean and largest relative error of the
    curvature in these; the same of the distance over the cell width, and of
    the normal, in the cells within three widths of the surface.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "clockTime.H"
#include "emptyFvPatch.H"
#include "fvMesh.H"
#include "IOdictionary.H"
#include "sphereOverlap.H"
#include "Time.H"
#include "transportedSurface.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A surface that is put where it is wanted
class placedSurface
:
    public dew::transportedSurface
{
public:

    placedSurface(const fvMesh& mesh, const dictionary& dict)
    :
        dew::transportedSurface(mesh, dict)
    {}

    void place(const scalarField& share)
    {
        alpha_.primitiveFieldRef() = share;
        alpha_.correctBoundaryConditions();
    }

    const dew::meshSymmetry& symmetry() const { return symmetry_; }

    void advect
    (
        const surfaceScalarField&, const volVectorField&, const volScalarField&
    ) override
    {}
};


//- Twice the part of the triangle (0, p, q) inside the circle
scalar sector(const vector& p, const vector& q, const scalar R)
{
    const vector d(q - p);
    const scalar a = magSqr(d);
    const scalar b = p & d;
    const scalar disc = sqr(b) - a*(magSqr(p) - sqr(R));
    const auto cross = [](const vector& u, const vector& v)
    {
        return u.x()*v.y() - u.y()*v.x();
    };
    const auto arc = [&](const vector& u, const vector& v)
    {
        return sqr(R)*std::atan2(cross(u, v), u & v);
    };
    if (disc <= 0)
    {
        return arc(p, q);
    }
    const scalar root = std::sqrt(disc);
    const scalar t0 = max((-b - root)/a, scalar(0));
    const scalar t1 = min((-b + root)/a, scalar(1));
    if (t0 >= t1)
    {
        return arc(p, q);
    }
    const vector x0(p + t0*d), x1(p + t1*d);
    return arc(p, x0) + cross(x0, x1) + arc(x1, q);
}


//- Shares of the cells that are in a disc, by their faces on an empty patch
void disc
(
    const fvMesh& mesh, const vector& axis, const point& centre,
    const scalar R, scalarField& share
)
{
    const vector e0(normalised(axis.y() ? vector(0, 0, 1) : vector(0, 1, 0)));
    const vector e1(axis ^ e0);
    const auto in2D = [&](const point& x)
    {
        const vector d(x - centre);
        return vector(d & e0, d & e1, 0);
    };

    share = 0;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            forAll(patch, i)
            {
                if ((patch.faceAreas()[i] & axis) > 0)
                {
                    const face& f = patch[i];
                    scalar area = 0;
                    forAll(f, j)
                    {
                        area +=
                            sector
                            (
                                in2D(mesh.points()[f[j]]),
                                in2D(mesh.points()[f.nextLabel(j)]),
                                R
                            );
                    }
                    share[patch.faceCells()[i]] =
                        max(scalar(0), min(scalar(1),
                            0.5*area/mag(patch.faceAreas()[i])));
                }
            }
        }
    }
}


struct errors
{
    label n = 0;
    scalar sum = 0, largest = 0;

    void add(const scalar e)
    {
        n++;
        sum += mag(e);
        largest = max(largest, mag(e));
    }

    void print(Ostream& os)
    {
        reduce(n, sumOp<label>());
        reduce(sum, sumOp<scalar>());
        reduce(largest, maxOp<scalar>());
        if (Pstream::master())
        {
            os  << ' ' << n << ' ' << sum/max(n, 1) << ' ' << largest;
        }
    }
};

} // End anonymous namespace

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::addOption("repeat", "times", "of each shape, for its time");
    #include "setRootCase.H"
    const label repeat = args.lookupOrDefault<label>("repeat", 1);
    #include "createTime.H"

    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion, runTime.timeName(), runTime,
            IOobject::MUST_READ
        )
    );
    const auto uniform = [&](const word& name, const scalar value)
    {
        return volScalarField
        (
            IOobject(name, runTime.timeName(), mesh),
            mesh, dimensionedScalar("value", dimless, value)
        );
    };
    const volScalarField one(uniform("alphac", 1));
    const volScalarField mu(uniform("mu", 1e-3));
    const volScalarField sigma(uniform("sigma", 0.07));
    const volVectorField U
    (
        IOobject("U", runTime.timeName(), mesh), mesh,
        dimensionedVector(dimVelocity, Zero)
    );

    const IOdictionary properties
    (
        IOobject
        (
            "surfaceProperties", runTime.constant(), mesh, IOobject::MUST_READ
        )
    );
    const IOdictionary dict
    (
        IOobject("shapesDict", runTime.system(), mesh, IOobject::MUST_READ)
    );
    const bool flat = mesh.nGeometricD() == 2 && mesh.nSolutionD() == 2;
    vector axis(Zero);
    for (direction i = 0; i < 3; i++)
    {
        axis[i] = mesh.geometricD()[i] < 0;
    }

    Sout.precision(16);
    for (const entry& e : PtrList<entry>(dict.lookup("shapes")))
    {
        const dictionary& shape = e.dict();
        const point centre(shape.get<point>("centre"));
        const point image(shape.lookupOrDefault<point>("image", centre));
        const scalar R = shape.get<scalar>("radius");

        dictionary changed(properties);
        changed.set("contactAngles", shape.subOrEmptyDict("contactAngles"));
        placedSurface surface(mesh, changed);

        scalarField share(mesh.nCells()), area(mesh.nCells());
        const bool solid = !flat || surface.symmetry().wedge();
        if (solid)
        {
            surfaceScalarField faces
            (
                IOobject("faces", runTime.timeName(), mesh), mesh,
                dimensionedScalar(dimless, Zero)
            );
            dew::sphereOverlap(mesh, surface.symmetry()).calculate
            (
                dew::sphericalCap
                (
                    centre,
                    surface.symmetry().wedge()
                  ? surface.symmetry().axis() : vector(0, 0, 1),
                    R, 0.5*constant::mathematical::pi
                ),
                share, area, faces
            );
        }
        else
        {
            disc(mesh, axis, centre, R, share);
            if (shape.found("image"))
            {
                scalarField other(share.size());
                disc(mesh, axis, image, R, other);
                share += other;
            }
        }
        surface.place(share);

        const clockTime watch;
        for (label i = 0; i < repeat; i++)
        {
            surface.correct({U, mu, sigma, one}, true);
        }
        const scalar time = watch.elapsedTime()/repeat;

        errors curvature, distance, normal;
        const scalar exact = (solid ? 2 : 1)/R;
        forAll(share, celli)
        {
            if (surface.crossed(share[celli]))
            {
                curvature.add(2*surface.curvature()[celli]/exact - 1);
            }
            const scalar thickness =
                surface.symmetry().wedge()
              ? mesh.bounds().span().y()*mesh.C()[celli].x()
               /mesh.bounds().max().x()
              : axis & mesh.bounds().span();
            const scalar dx =
                flat || surface.symmetry().wedge()
              ? std::sqrt(mesh.V()[celli]/thickness)
              : std::cbrt(mesh.V()[celli]);
            vector out(mesh.C()[celli] - centre);
            const vector other(mesh.C()[celli] - image);
            if (magSqr(other) < magSqr(out))
            {
                out = other;
            }
            if (surface.symmetry().wedge())
            {
                out.x() /= surface.symmetry().cosHalfAngle();
            }
            const scalar psi = R - mag(out);
            if (mag(psi) < 3*dx)
            {
                distance.add((surface.psi()[celli] - psi)/dx);
                normal.add
                (
                    mag(surface.n()[celli] - out/max(mag(out), VSMALL))
                );
            }
        }
        surface.report(Info);
        Info<< "shape";
        curvature.print(Sout);
        distance.print(Sout);
        normal.print(Sout);
        Info<< ' ' << time << endl;
    }

    return 0;
}
