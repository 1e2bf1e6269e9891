/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "diffusionSmoothing.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"
#include "mathematicalConstants.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(diffusionSmoothing, 0);
    addToRunTimeSelectionTable(smoothing, diffusionSmoothing, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What is left out of the series [-], and the most terms it may have
constexpr Foam::scalar cutOff = 1e-12;
constexpr Foam::label maxTerms = 4096;

//- Coefficients of Chebyshev's polynomials on -1 <= x <= 1, from the function
//  at n points
template<class Function>
Foam::scalarList chebyshevSeries(const Function& f, const Foam::label n)
{
    using Foam::scalar, Foam::label;
    const scalar pi = Foam::constant::mathematical::pi;

    Foam::scalarList values(n), result(n, scalar(0));
    for (label j = 0; j < n; j++)
    {
        values[j] = f(std::cos(pi*(j + 0.5)/n));
    }
    for (label k = 0; k < n; k++)
    {
        for (label j = 0; j < n; j++)
        {
            // k (2j + 1) modulo the period, for digits
            const label angle = (k*(2*j + 1)) % (4*n);
            result[k] += values[j]*std::cos(pi*angle/(2*n));
        }
        result[k] *= (k == 0 ? 1.0 : 2.0)/n;
    }
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::diffusionSmoothing::diffusionSmoothing
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    dict_(dict),
    mesh_(mesh),
    diameters_
    (
        dict.found("diameters")
      ? userEntry::positive(dict, "diameters", dimless) : 0
    ),
    steps_(dict.found("steps") ? userEntry::count(dict, "steps") : 0),
    length_(0),
    diffusion_(mesh, dict)
{
    userEntry::onlyThese(dict, {"type", "length", "diameters", "steps"});

    if (dict.found("length") == dict.found("diameters"))
    {
        FatalIOErrorInFunction(dict)
            << (
                   dict.found("length")
                 ? "Entries 'length' and 'diameters' contradict each other"
                 : "Entry 'length' or 'diameters' is missing"
               ) << nl
            << "Give the width of the smoothing by one of them: 'length' [m]"
            << " or 'diameters', a multiple of the largest particle"
            << exit(FatalIOError);
    }
    if (dict.found("length"))
    {
        length_ = userEntry::positive(dict, "length", dimLength);
        update();
        Info<< "Smoothing over " << length_ << " m: products "
            << series_.size() << nl << endl;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::diffusionSmoothing::checkLength() const
{
    const vector span(mesh_.bounds().span());
    scalar smallest = GREAT;
    for (direction k = 0; k < 3; k++)
    {
        if (mesh_.geometricD()[k] > 0)
        {
            smallest = min(smallest, span[k]);
        }
    }

    if (length_ > 0.5*smallest)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << (diameters_ > 0 ? "diameters" : "length")
            << "' makes a smoothing over " << length_
            << " m, above half of the smallest extent of the mesh, "
            << smallest << " m" << nl
            << "Lower it to less than "
            << 0.5*smallest/(diameters_ > 0 ? length_/diameters_ : 1)
            << exit(FatalIOError);
    }
}


void Foam::dew::diffusionSmoothing::findSeries()
{
    // Diffusion times rate at x = -1; x = 1 is where phi is constant
    const scalar most = 0.25*sqr(length_)*diffusion_.rate();

    const auto decay = [&](const scalar x)
    {
        const scalar s = 0.5*most*(1 - x);
        return steps_ ? std::pow(1 + s/steps_, -steps_) : std::exp(-s);
    };

    label n = 32, terms = 0;
    do
    {
        n *= 2;
        if (n > maxTerms)
        {
            FatalIOErrorInFunction(dict_)
                << "Smoothing over " << length_ << " m takes more than "
                << maxTerms/2 << " products: the smallest cells of the mesh"
                << " are too small for it" << nl
                << "Use a shorter smoothing, or a mesh whose cells are not"
                << " below a hundredth of it" << exit(FatalIOError);
        }
        series_ = chebyshevSeries(decay, n);

        terms = n;
        scalar rest = 0;
        while (terms > 2 && rest + mag(series_[terms - 1]) < cutOff)
        {
            rest += mag(series_[--terms]);
        }
    } while (terms > n/2);

    // The content of the whole mesh stays to round-off
    series_.setSize(terms);
    const scalar whole = sum(series_);
    for (scalar& s : series_)
    {
        s /= whole;
    }
}


template<class Type>
void Foam::dew::diffusionSmoothing::averageValues(Field<Type>& values) const
{
    if (active())
    {
        diffusion_.chebyshev(series_, values);
    }
}


template<class Type>
void Foam::dew::diffusionSmoothing::spreadContents
(
    Field<Type>& contents
) const
{
    if (active())
    {
        const scalarField& V = mesh_.V();
        contents /= V;
        averageValues(contents);
        contents *= V;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::diffusionSmoothing::correct(const UList<scalar>& d)
{
    if (diameters_ > 0)
    {
        scalar largest = 0;
        for (const scalar di : d)
        {
            largest = max(largest, di);
        }
        reduce(largest, maxOp<scalar>());

        if (length_ != diameters_*largest)
        {
            length_ = diameters_*largest;
            update();
            Info<< "Smoothing over " << length_ << " m, " << diameters_
                << " diameters: products " << series_.size() << nl << endl;
        }
    }
}


void Foam::dew::diffusionSmoothing::update()
{
    if (active())
    {
        checkLength();
        diffusion_.correct();
        findSeries();
    }
}
