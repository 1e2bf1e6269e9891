/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactAngles.H"
#include "fvMesh.H"
#include "ListListOps.H"
#include "userEntry.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- New points, each once (neighbours may see the same one), instead of those
//  near to them. The others stay: a cell may be full or empty for a moment
void hold
(
    Foam::pointField& held,
    const Foam::pointField& points,
    const Foam::scalar near
)
{
    Foam::DynamicList<Foam::point> all;
    const auto isNear = [&](const Foam::point& x, const Foam::scalar distance)
    {
        for (const Foam::point& other : all)
        {
            if (magSqr(x - other) < Foam::sqr(distance))
            {
                return true;
            }
        }
        return false;
    };
    for (const Foam::point& x : points)
    {
        if (!isNear(x, 1e-6*near))
        {
            all.append(x);
        }
    }
    Foam::DynamicList<Foam::point> others;
    for (const Foam::point& x : held)
    {
        if (!isNear(x, near))
        {
            others.append(x);
        }
    }
    all.append(others);
    held.transfer(all);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactAngles::contactAngles
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
:
    IOdictionary
    (
        IOobject
        (
            "contactLines", mesh.time().timeName(), "uniform", mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
        )
    ),
    mesh_(mesh),
    models_(mesh.boundary().size()),
    theta_(mesh.boundary().size()),
    held_(mesh.boundary().size()),
    started_(false)
{
    const dictionary& dict =
        userEntry::optionalDict(surfaceProperties, "contactAngles");

    for (const entry& e : dict)
    {
        const labelHashSet patches
        (
            mesh.boundaryMesh().patchSet
            (
                wordRes(1, wordRe(e.keyword())), false, false
            )
        );
        if (patches.empty())
        {
            FatalIOErrorInFunction(dict)
                << "No patch is named " << e.keyword() << " as in contactAngles"
                << nl << "Patches: " << mesh.boundaryMesh().names()
                << exit(FatalIOError);
        }

        for (const label patchi : patches)
        {
            if (!isA<wallFvPatch>(mesh.boundary()[patchi]))
            {
                FatalIOErrorInFunction(dict)
                    << "Patch " << mesh.boundary()[patchi].name()
                    << " in contactAngles is not a wall" << nl
                    << "Give it 'type wall' in constant/polyMesh/boundary, or"
                    << " remove the entry" << exit(FatalIOError);
            }
            models_.set(patchi, contactAngle::New(userEntry::dictOf(dict, e)));
            theta_[patchi].setSize(mesh.boundary()[patchi].size());
            theta_[patchi] = models_[patchi].start();

            const word& name = mesh.boundary()[patchi].name();
            if (models_[patchi].holds())
            {
                writeOpt() = IOobject::AUTO_WRITE;
            }
            if (models_[patchi].holds() && found(name))
            {
                held_[patchi] = pointField(lookup(name));
                started_ = true;
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::contactAngles::correct
(
    const label patchi,
    const label facei,
    const point& x,
    const vector& n,
    const surfaceFlow& flow,
    DynamicList<point>& line
)
{
    const fvPatch& patch = mesh_.boundary()[patchi];
    const label celli = patch.faceCells()[facei];
    const vector m(patch.Sf()[facei]/patch.magSf()[facei]);
    const scalar cosTheta = max(min(-(n & m), scalar(1)), scalar(-1));

    // Along the wall, out of the liquid
    vector t(n - (n & m)*m);
    const scalar sinTheta = mag(t);
    if (sinTheta < SMALL)
    {
        return;
    }
    t /= sinTheta;

    const scalar H = (patch.Cf()[facei] - x) & m;
    const point below(x + H*m);

    contactLineState state;
    state.angle = Foam::acos(cosTheta);
    state.held = state.angle;
    state.speed = flow.U[celli] & t;
    state.mu = flow.mu[celli];
    state.sigma = flow.sigma[celli];

    scalar L = H*cosTheta/sinTheta;
    const contactAngle& model = models_[patchi];
    if (model.holds() && held_[patchi].size())
    {
        const pointField& points = held_[patchi];
        label nearest = 0;
        forAll(points, i)
        {
            if (magSqr(points[i] - below) < magSqr(points[nearest] - below))
            {
                nearest = i;
            }
        }
        const scalar way = (points[nearest] - below) & t;
        state.held = Foam::atan2(H, way);
        L = model.theta(state) == state.held ? way : L;
    }

    theta_[patchi][facei] = model.theta(state);
    if (model.holds())
    {
        line.append(below + L*t);
    }
}


void Foam::dew::contactAngles::correct
(
    const interfacePlanes& planes,
    const surfaceFlow& flow
)
{
    forAll(models_, patchi)
    {
        if (!has(patchi))
        {
            continue;
        }

        const fvPatch& patch = mesh_.boundary()[patchi];
        const labelUList& cells = patch.faceCells();
        theta_[patchi].setSize(patch.size(), models_[patchi].start());

        DynamicList<point> line;
        forAll(cells, facei)
        {
            const label i = planes.of(cells[facei]);
            if (i >= 0)
            {
                correct(patchi, facei, planes.x()[i], planes.n()[i], flow, line);
            }
        }

        if (models_[patchi].holds())
        {
            List<pointField> lines(Pstream::nProcs());
            lines[Pstream::myProcNo()].transfer(line);
            Pstream::gatherList(lines);
            Pstream::scatterList(lines);
            hold
            (
                held_[patchi],
                ListListOps::combine<pointField>
                (
                    lines, accessOp<pointField>()
                ),
                4/max(gAverage(patch.deltaCoeffs()), VSMALL)
            );

            if (!started_ && held_[patchi].empty())
            {
                FatalErrorInFunction
                    << "No contact line is on patch " << patch.name()
                    << " at the start, where contactAngles of constant/"
                    << "surfaceProperties has '" << models_[patchi].type()
                    << "'" << nl
                    << "Give the patch that the surface touches, or 'constant'"
                    << exit(FatalError);
            }
        }
    }
    started_ = true;
}


bool Foam::dew::contactAngles::writeData(Ostream& os) const
{
    forAll(models_, patchi)
    {
        if (has(patchi) && models_[patchi].holds())
        {
            os.writeEntry(mesh_.boundary()[patchi].name(), held_[patchi]);
        }
    }
    return os.good();
}


Foam::vector Foam::dew::contactAngles::normal
(
    const label patchi,
    const label facei,
    const vector& given
) const
{
    const fvPatch& patch = mesh_.boundary()[patchi];
    const vector m(patch.Sf()[facei]/patch.magSf()[facei]);
    const vector t(given - (given & m)*m);
    const scalar size = mag(t);

    if (size > SMALL)
    {
        return
            has(patchi)
          ? t/size*Foam::sin(theta_[patchi][facei])
          - m*Foam::cos(theta_[patchi][facei])
          : t/size;
    }
    return has(patchi) ? given : vector::zero;
}


Foam::tmp<Foam::vectorField> Foam::dew::contactAngles::normal
(
    const label patchi,
    const vectorField& given
) const
{
    tmp<vectorField> tn(new vectorField(given.size()));
    forAll(given, facei)
    {
        tn.ref()[facei] = normal(patchi, facei, given[facei]);
    }
    return tn;
}
